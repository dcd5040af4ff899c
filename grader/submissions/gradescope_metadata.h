// submission_metadata.yml of Gradescope: who has sent which folder.
//
//     submission_123:
//       :submitters:
//       - :name: Ada Lovelace
//         :sid: '1815'
//         :email: ada@example.edu
#pragma once

#include "grader/submissions/class_export.h"

#include <map>

namespace raylab {

// The students by the name of their folder. Lines that are something else are passed over.
std::map<std::string, std::vector<Student>> read_gradescope_metadata(const std::string& text);

} // namespace raylab
