// Lists as one column of the journal: JSON.
#pragma once

#include "grader/submissions/class_export.h"

#include <string>
#include <vector>

namespace raylab {

std::string text_of(const std::vector<std::string>& words);
std::vector<std::string> words_of(const std::string& text);
std::string text_of(const std::vector<Student>& students);
std::vector<Student> students_of(const std::string& text);

} // namespace raylab
