#include "grader/bench/figures.h"

#include <fmt/format.h>

#include <cmath>

namespace raylab::bench {

std::string figure(double value, const char* format) {
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

// The median over its interval, an end of which may be open.
std::string with_interval(const Measured& m, int digits) {
    if (!m.is_known()) return "-";
    const auto end = [&](double v) {
        return std::isfinite(v) ? fmt::format("{:.{}g}", v, digits) : "open";
    };
    return fmt::format("{:.{}g} [{}, {}]", m.median, digits, end(m.low), end(m.high));
}

std::string ratio_text(const std::optional<Measured>& ratio) {
    return ratio ? with_interval(*ratio, 3) : "-";
}

// A field of CSV. It is quoted, with its quotes doubled, if it contains a comma, a quote or a line
// end.
std::string csv_text(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string csv_number(double value) {
    return std::isfinite(value) ? fmt::format("{:.7g}", value) : "";
}

std::string csv_measured(const Measured& m) {
    return csv_number(m.median) + "," + csv_number(m.low) + "," + csv_number(m.high);
}

std::string csv_measured(const std::optional<Measured>& m) { return m ? csv_measured(*m) : ",,"; }

std::string header_of(const char* name) { return fmt::format("{0},{0}_low,{0}_high,", name); }

} // namespace raylab::bench
