// Harmless variations of a solution: another generator, another block size, another way to choose a
// lobe. They are right too, so every test of the lab must pass on them.
//
// labs/NN_name/variations/NAME.json:
//     { "title": "Blocks of 96 threads", "file": "renderer.cu",
//       "find": ["lines as they stand in the solution"], "replace": ["lines in their place"] }
#pragma once

#include "grader/course/lab_sheet.h"

#include <string>
#include <vector>

namespace raylab {

struct Variation {
    std::string name;  // of its file, without the ending
    std::string place; // of its `find`, for errors
    std::string title, file, find, replace;

    // The text with `find` replaced. Throws CourseError if it is not there exactly once: a
    // variation that changes nothing proves nothing.
    std::string apply(const std::string& text) const;
};

// All of a lab, by name. Throws CourseError.
std::vector<Variation> read_variations(const LabSheet& sheet);

} // namespace raylab
