#include "grader/course/said.h"

#include <fmt/format.h>

#include <regex>
#include <sstream>

namespace raylab {

namespace {

constexpr std::size_t most_bytes = 200;

// On the terminal a failure of the report, "file:line\nwords", is "file:line: Failure\nwords".
void drop_failure(std::string& text, const std::string& failure) {
    const std::size_t line = failure.find('\n');
    if (line == failure.npos) return;
    const std::string printed = failure.substr(0, line) + ": Failure" + failure.substr(line);
    if (const std::size_t at = text.find(printed); at != text.npos) text.erase(at, printed.size());
}

} // namespace

std::vector<std::string> said_by_test(const std::string& output, const std::string& name,
                                      const std::vector<std::string>& failures, int most) {
    const std::string begin = "[ RUN      ] " + name + "\n";
    const std::size_t from = output.find(begin);
    if (from == output.npos) return {};
    std::string text = output.substr(from + begin.size());
    for (const std::string& failure : failures) drop_failure(text, failure);

    static const std::regex end(R"(\[  FAILED  \] .*|\[       OK \] .*)");
    static const std::regex stub(R"(task [0-9.]+ .+ is not implemented: .*)");
    static const std::regex report(
        R"(\S+:[0-9]+(:[0-9]+)?: (error|warning|note|runtime error): .*)");
    static const std::regex sanitizer("=+|(==[0-9]+==|WARNING: ThreadSanitizer).*");
    std::vector<std::string> said;
    int more = 0;
    bool in_report = false; // its further lines are indented
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_match(line, end) || std::regex_match(line, sanitizer)) break;
        in_report = std::regex_match(line, report) || (in_report && line.starts_with("  "));
        if (in_report || line.empty() || std::regex_match(line, stub)) continue;
        if (static_cast<int>(said.size()) < most)
            said.push_back(line.substr(0, most_bytes));
        else
            ++more;
    }
    if (more > 0) said.push_back(fmt::format("... and {} more lines", more));
    return said;
}

} // namespace raylab
