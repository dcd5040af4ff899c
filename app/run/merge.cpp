// See merge.h.
#include "app/run/merge.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace raylab::app {

using simt::Finding;
using simt::SourcePlace;

namespace {

// Kinds that say that an address is wrong. The same mistake may look like several of them, and the
// mode with the bounds knows it best.
bool is_about_an_address(const std::string& kind) {
    static const std::set<std::string> kinds = {
        "null-pointer", "wild-address",   "out-of-bounds", "use-after-free", "index-out-of-bounds",
        "host-memory",  "shared-overrun", "local-overrun", "freed-pointer",  "misaligned"};
    return kinds.count(kind) > 0;
}

using Line = std::pair<std::string, int>;
Line line_of(const SourcePlace& place) { return {place.file, place.line}; }

bool stands(const Finding& finding, const std::map<Line, std::string>& bad_lines) {
    const auto bad = bad_lines.find(line_of(finding.place));
    if (finding.kind == "race")
        return bad == bad_lines.end() &&
               (!finding.other || bad_lines.count(line_of(finding.other->place)) == 0);
    return !is_about_an_address(finding.kind) || bad->second == finding.mode;
}

} // namespace

std::vector<Finding> merged(const std::vector<Execution>& executions) {
    std::map<Line, std::string> bad_lines; // the mode whose word holds there
    for (const Execution& execution : executions)
        for (const Finding& finding : execution.findings)
            if (is_about_an_address(finding.kind)) {
                std::string& mode = bad_lines[line_of(finding.place)];
                if (mode.empty() || finding.mode == "bounds") mode = finding.mode;
            }
    std::vector<Finding> list;
    std::map<std::tuple<std::string, Line, Line>, std::size_t> known;
    for (const Execution& execution : executions)
        for (const Finding& finding : execution.findings) {
            if (!stands(finding, bad_lines)) continue;
            const Line other =
                finding.other && finding.kind == "race" ? line_of(finding.other->place) : Line{};
            // Two sanitizers may have two words for it.
            const std::string kind = is_about_an_address(finding.kind) ? "address" : finding.kind;
            const auto [at, is_new] =
                known.try_emplace({kind, line_of(finding.place), other}, list.size());
            if (is_new) {
                list.push_back(finding);
                continue;
            }
            Finding& first = list[at->second];
            first.count = std::max(first.count, finding.count);
            if (first.mode.find(finding.mode) == std::string::npos)
                first.mode += ", " + finding.mode;
        }
    std::stable_sort(list.begin(), list.end(),
                     [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
    return list;
}

} // namespace raylab::app
