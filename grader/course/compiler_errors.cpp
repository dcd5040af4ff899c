#include "grader/course/compiler_errors.h"

#include <sstream>
#include <utility>

namespace raylab {

namespace {

constexpr std::size_t shown_error_lines = 40;

} // namespace

std::string compiler_errors(const std::string& output, const std::filesystem::path& root) {
    std::istringstream lines(output);
    std::string errors;
    std::size_t shown = 0;
    bool command_follows = false;
    for (std::string line; std::getline(lines, line);) {
        const bool is_command = std::exchange(command_follows, line.starts_with("FAILED: "));
        if (is_command || line.starts_with("[") || line.starts_with("FAILED: ") ||
            line.starts_with("ninja: "))
            continue;
        for (std::size_t at; (at = line.find(root.string() + "/")) != line.npos;)
            line.erase(at, root.string().size() + 1);
        if (++shown > shown_error_lines) return errors + "... and more\n";
        errors += line + "\n";
    }
    return errors;
}

} // namespace raylab
