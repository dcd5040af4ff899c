// Reads "f.cu:5:7: error: text", as g++, clang and the rewriter write it; see compiler_errors.h.
#include "app/run/compiler_errors.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace raylab::app {

using simt::Finding;
using simt::SourcePlace;

std::vector<Finding> compiler_errors(const std::string& words,
                                     const std::vector<std::string>& sources) {
    static const std::regex said(R"(^(.+?):(\d+)(?::(\d+))?: (?:fatal )?error: (.*)$)");
    static const std::regex led(
        R"(^(?:In file included from +)?(.+?):(\d+)(?::(\d+))?[:,]?(?: .*)?$)");
    static const std::regex linker(R"(undefined reference to `(.*)'$)");
    const auto is_source = [&](const std::string& file) {
        return std::find(sources.begin(), sources.end(), file) != sources.end();
    };
    std::vector<Finding> findings;
    const auto add = [&](const SourcePlace& place, const std::string& message,
                         const std::string& advice) {
        Finding finding;
        finding.kind = "does-not-compile";
        finding.place = place;
        finding.message = message;
        finding.advice = advice;
        findings.push_back(finding);
    };
    SourcePlace led_by; // the latest line of a source that the compiler named
    std::istringstream lines(words);
    for (std::string line; std::getline(lines, line);) {
        std::smatch part;
        const auto place = [&] {
            return SourcePlace{part[1], std::atoi(part[2].str().c_str()),
                               std::atoi(part[3].str().c_str())};
        };
        if (std::regex_match(line, part, said)) {
            if (is_source(part[1]) || led_by.line == 0)
                add(place(), part[4], "");
            else
                add(led_by, part[4], "this line leads to the error in " + part[1].str());
        } else if (std::regex_search(line, part, linker)) {
            add({sources.front(), 0, 0}, "the linker finds no definition of " + part[1].str(),
                "give the file that defines it too, or define it");
        } else if (std::regex_match(line, part, led) && is_source(part[1])) {
            led_by = place();
        }
    }
    return simt::folded(findings);
}

} // namespace raylab::app
