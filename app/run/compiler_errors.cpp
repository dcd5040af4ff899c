// Reads "f.cu:5:7: error: text", as g++, clang and the rewriter write it; see compiler_errors.h.
#include "app/run/compiler_errors.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace raylab::app {

using simt::Finding;
using simt::SourcePlace;

std::vector<Finding> compiler_errors(const std::string& words,
                                     const std::vector<std::string>& sources,
                                     const std::string& folder) {
    static const std::regex said(R"(^(.+?):(\d+)(?::(\d+))?: (?:fatal )?error: (.*)$)");
    static const std::regex led(
        R"(^(?:In file included from +)?(.+?):(\d+)(?::(\d+))?[:,]?(?: .*)?$)");
    static const std::regex undefined(R"((?:([^: ]+):(\d+): )?undefined reference to `(.*)'$)");
    static const std::regex twice(R"(multiple definition of `(.+)'; (?:[^:]+:)?([^:]+):(\d+): )"
                                  R"(first defined here$)");
    const auto is_source = [&](const std::string& file) {
        return std::find(sources.begin(), sources.end(), file) != sources.end();
    };
    // The user's name of a file that the linker names.
    const auto named = [&](const std::string& file) {
        return file.starts_with(folder + "/") ? file.substr(folder.size() + 1) : file;
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
        } else if (std::regex_search(line, part, undefined)) {
            const std::string file = named(part[1]);
            add(is_source(file) ? SourcePlace{file, std::atoi(part[2].str().c_str()), 0}
                                : SourcePlace{sources.front(), 0, 0},
                "the linker finds no definition of " + part[3].str(),
                "give the file that defines it too, or define it");
        } else if (std::regex_search(line, part, twice)) {
            add({named(part[2]), std::atoi(part[3].str().c_str()), 0},
                part[1].str() + " is defined here, and again in another file",
                "in a header that two files include write `inline` before it (nvcc keeps "
                "__device__ functions to their file, the CPU machine does not); else delete one, "
                "or "
                "let it be `static`");
        } else if (std::regex_match(line, part, led) && is_source(part[1])) {
            led_by = place();
        }
    }
    return simt::folded(findings);
}

} // namespace raylab::app
