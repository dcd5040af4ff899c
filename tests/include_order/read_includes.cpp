#include "tests/include_order/read_includes.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace raylab::order {

namespace fs = std::filesystem;

namespace {

// "common/math", "labs/03_wavefront", "grader", "app": who is meant by a rule.
std::string part_of(const std::string& file) {
    const std::size_t first = file.find('/'), second = file.find('/', first + 1);
    const std::string top = file.substr(0, first);
    return top == "common" || top == "labs" ? file.substr(0, second) : top;
}

bool may_include(const std::string& from, const std::string& to,
                 const std::vector<std::string>& rooms) {
    if (from == to || from == "app") return true;
    const auto height = [&rooms](const std::string& part) {
        return std::find(rooms.begin(), rooms.end(), part.substr(part.find('/') + 1));
    };
    if (!to.starts_with("common/")) return false;
    return !from.starts_with("common/") || height(to) < height(from);
}

} // namespace

Includes read_includes(const fs::path& root) {
    static const std::regex line("^#include \"((?:common|labs|grader|app)/[^\"]+)\"");
    Includes includes;
    for (const char* top : {"common", "labs", "grader", "app"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
            const std::string name = entry.path().lexically_relative(root).generic_string();
            const std::string ending = entry.path().extension().string();
            if (ending != ".h" && ending != ".cpp" && ending != ".cu") continue;
            if (name.find("/tests/") != std::string::npos) continue;
            std::vector<std::string>& included = includes[name];
            std::ifstream file(entry.path());
            std::smatch match;
            for (std::string text; std::getline(file, text);)
                if (std::regex_search(text, match, line)) included.push_back(match[1]);
        }
    return includes;
}

std::vector<std::string> rooms_from_the_bottom(const std::string& page) {
    const std::size_t begin = page.find("Inside `common`, from the bottom");
    if (begin == std::string::npos)
        throw std::runtime_error(
            "docs/architecture.md has no list of the rooms of common: expected "
            "a paragraph 'Inside `common`, from the bottom'");
    std::vector<std::string> rooms;
    std::istringstream lines(page.substr(begin));
    std::smatch match;
    for (std::string text; std::getline(lines, text);) {
        if (std::regex_search(text, match, std::regex("^    ([a-z_]+) ")))
            rooms.push_back(match[1]);
        else if (!rooms.empty() && !text.starts_with("     "))
            break; // the list is over
    }
    return rooms;
}

std::vector<std::string> upward(const Includes& includes, const std::vector<std::string>& rooms) {
    std::set<std::string> sentences;
    for (const auto& [file, included] : includes) {
        const std::string from = part_of(file);
        if (from.starts_with("common/") && std::ranges::count(rooms, from.substr(7)) == 0)
            sentences.insert(from + " is not in the list of docs/architecture.md");
        for (const std::string& other : included)
            if (!may_include(from, part_of(other), rooms))
                sentences.insert(fmt::format("{} includes {}, and {} is not below {}", file, other,
                                             part_of(other), from));
    }
    return {sentences.begin(), sentences.end()};
}

std::vector<std::string> circle(const Includes& includes) {
    std::set<std::string> done;
    std::vector<std::string> path;
    const auto visit = [&](const auto& self, const std::string& file) -> bool {
        if (done.contains(file)) return false;
        const auto again = std::ranges::find(path, file) - path.begin();
        const bool closes = again < std::ssize(path);
        path.push_back(file);
        if (closes) {
            path.erase(path.begin(), path.begin() + again);
            return true;
        }
        if (const auto entry = includes.find(file); entry != includes.end())
            for (const std::string& other : entry->second)
                if (self(self, other)) return true;
        path.pop_back();
        done.insert(file);
        return false;
    };
    for (const auto& [file, included] : includes)
        if (visit(visit, file)) return path;
    return {};
}

} // namespace raylab::order
