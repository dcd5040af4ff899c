#include "grader/submissions/gradescope_metadata.h"

#include "grader/results/text.h"

#include <sstream>

namespace raylab {

namespace {

// A scalar of YAML as Ruby writes it: plain, 'single' with '' for ', "double" with backslashes.
std::string scalar(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin == text.npos) return "";
    std::string value = text.substr(begin, text.find_last_not_of(" \r") + 1 - begin);
    const char quote = value.front();
    if (value.size() < 2 || (quote != '\'' && quote != '"') || value.back() != quote) return value;
    std::string plain;
    for (std::size_t i = 1; i + 1 < value.size(); ++i) {
        const bool escaped = quote == '"' ? value[i] == '\\' : value[i] == '\'';
        if (escaped && i + 2 < value.size()) ++i;
        plain += value[i];
    }
    return plain;
}

} // namespace

std::map<std::string, std::vector<Student>> read_gradescope_metadata(const std::string& text) {
    std::map<std::string, std::vector<Student>> students;
    std::vector<Student>* current = nullptr;
    bool in_submitters = false;
    std::istringstream lines(clean_utf8(text));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("submission_") && line.ends_with(":")) {
            current = &students[line.substr(0, line.size() - 1)];
            in_submitters = false;
            continue;
        }
        const std::size_t begin = line.find_first_not_of(" -");
        if (!current || begin == line.npos) continue;
        const std::string entry = line.substr(begin);
        const auto value_of = [&entry](const std::string& key) {
            return entry.starts_with(key) ? scalar(entry.substr(key.size())) : std::string();
        };
        if (begin <= 2 && entry.starts_with(":")) in_submitters = entry == ":submitters:";
        const bool begins_one = line.find("- ") < begin;
        if (begins_one) in_submitters = in_submitters || entry.starts_with(":name:");
        if (!in_submitters) continue;
        if (begins_one) current->push_back({});
        if (current->empty()) continue;
        Student& student = current->back();
        if (entry.starts_with(":name:")) student.name = value_of(":name:");
        if (entry.starts_with(":sid:")) student.id = value_of(":sid:");
        if (entry.starts_with(":email:")) student.email = value_of(":email:");
    }
    return students;
}

} // namespace raylab
