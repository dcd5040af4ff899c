#include "grader/class/journal_text.h"

#include "grader/results/text.h"

#include <nlohmann/json.hpp>

namespace raylab {

using nlohmann::json;

std::string text_of(const std::vector<std::string>& words) {
    constexpr std::size_t most = 200; // who sends 20,000 files has said enough with the first
    json list = json::array();
    for (const std::string& word : words)
        if (list.size() < most) list.push_back(clean_utf8(shortened(word, 300)));
    return list.dump();
}

std::vector<std::string> words_of(const std::string& text) {
    return json::parse(text).get<std::vector<std::string>>();
}

std::string text_of(const std::vector<Student>& students) {
    json list = json::array();
    for (const Student& student : students)
        list.push_back(
            {clean_utf8(student.id), clean_utf8(student.name), clean_utf8(student.email)});
    return list.dump();
}

std::vector<Student> students_of(const std::string& text) {
    std::vector<Student> students;
    for (const json& one : json::parse(text)) students.push_back({one[0], one[1], one[2]});
    return students;
}

} // namespace raylab
