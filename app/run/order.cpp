// See order.h.
#include "app/run/order.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace raylab::app {

namespace {

constexpr double rounding = 1e-4; // relative: sums of floats in another order differ less

bool same_word(const std::string& a, const std::string& b) {
    if (a == b) return true;
    char *end_a = nullptr, *end_b = nullptr;
    const double x = std::strtod(a.c_str(), &end_a), y = std::strtod(b.c_str(), &end_b);
    if (end_a == a.c_str() || end_b == b.c_str() || std::string(end_a) != end_b) return false;
    const bool is_whole = a.find_first_of(".enEN") == a.npos && b.find_first_of(".enEN") == b.npos;
    return !is_whole && std::abs(x - y) <= rounding * std::max(std::abs(x), std::abs(y));
}

bool same_line(const std::string& a, const std::string& b) {
    std::istringstream left(a), right(b);
    std::string x, y;
    for (;;) {
        const bool more = bool(left >> x);
        if (more != bool(right >> y)) return false;
        if (!more) return true;
        if (!same_word(x, y)) return false;
    }
}

// The first line that differs, counted from 1, and how each has it. Line 0: none.
struct Difference {
    int line = 0;
    std::string left, right;
};
Difference first_difference(const std::string& a, const std::string& b) {
    std::istringstream left(a), right(b);
    Difference at;
    for (;;) {
        ++at.line;
        const bool more_left = bool(std::getline(left, at.left));
        const bool more_right = bool(std::getline(right, at.right));
        if (!more_left) at.left = "(nothing)";
        if (!more_right) at.right = "(nothing)";
        if (!more_left && !more_right) return {};
        if (more_left != more_right || !same_line(at.left, at.right)) return at;
    }
}

} // namespace

std::vector<simt::Finding> order_dependence(const std::vector<Execution>& runs,
                                            const std::string& source) {
    if (runs.size() < 3 || first_difference(runs[0].process.output, runs[1].process.output).line)
        return {};
    for (std::size_t i = 2; i < runs.size(); ++i) {
        const Difference at = first_difference(runs[0].process.output, runs[i].process.output);
        if (at.line == 0) continue;
        simt::Finding finding;
        finding.kind = "order-dependence";
        finding.severity = simt::Severity::warning;
        finding.place = {source, 0, 0};
        finding.message =
            fmt::format("the output depends on the order in which threads run: line {} "
                        "is \"{}\" with the order {}, and \"{}\" with {}",
                        at.line, at.left, runs[0].order, at.right, runs[i].order);
        finding.advice =
            "look for threads or blocks that read what others write in the same launch; "
            "--machine watch names the lines";
        finding.mode = "order";
        return {finding};
    }
    return {};
}

} // namespace raylab::app
