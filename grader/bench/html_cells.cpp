#include "grader/bench/html_cells.h"

#include "grader/report/html.h"

#include <fmt/format.h>

#include <cmath>

namespace raylab::bench::html {

// Four digits are more than any of these figures can bear.
std::string digits(double v) {
    const double size = std::abs(v);
    if (std::isinf(v)) return v < 0 ? "&minus;&infin;" : "&infin;";
    if (size != 0 && (size < 1e-3 || size >= 1e6)) {
        const int power = static_cast<int>(std::floor(std::log10(size)));
        return fmt::format("{:.2f}&#8239;&middot;&#8239;10<sup>{}</sup>", v / std::pow(10, power),
                           power);
    }
    return fmt::format("{:.{}f}", v, size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 4);
}

std::string text(const nlohmann::ordered_json& value) {
    return escape_html(value.get<std::string>());
}

// The median over its interval, an end of which may be open.
std::string measured(const nlohmann::ordered_json& m, const char* prefix) {
    if (!m.is_object() || m.at("median").is_null()) return unknown;
    const auto end = [&](const char* name) {
        return m.at(name).is_null() ? "open" : digits(m.at(name));
    };
    return fmt::format("{}{}<span class=\"interval\">{} &ndash; {}</span>", prefix,
                       digits(m.at("median")), end("low"), end("high"));
}

std::string cell(const std::string& content) { return "<td class=\"number\">" + content + "</td>"; }

std::string head(const std::vector<std::pair<const char*, const char*>>& columns) {
    std::string cells;
    for (std::size_t i = 0; i < columns.size(); ++i)
        cells += fmt::format("<th{} title=\"{}\">{}</th>", i > 0 ? " class=\"number\"" : "",
                             columns[i].second, columns[i].first);
    return "<thead><tr>" + cells + "</tr></thead>";
}

} // namespace raylab::bench::html
