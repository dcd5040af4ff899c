// Changes of a solution that its tests are tested with.
//
// Harmless variations: another generator, another block size, another way to choose a lobe. They
// are right too, so every test of the lab must pass on them.
//
// labs/NN_name/variations/NAME.json:
//     { "title": "Blocks of 96 threads", "file": "renderer.cu",
//       "find": ["lines as they stand in the solution"], "replace": ["lines in their place"] }
//
// Mistakes: what students really write. The task must be WRONG, and the first thing that is said of
// it must name the cause.
//
// labs/NN_name/mistakes/NAME.json: the same, and
//     { "task": "2.3", "cause": ["words of the right cause", "or other words for it"] }
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

struct Mistake {
    Variation change;
    std::string task;
    std::vector<std::string> causes; // one of them must be there, whatever the case of the letters

    // Whether a sentence that `check` says names the cause.
    bool is_named_by(const std::string& fact) const;
};

// All of a lab, by name. Throw CourseError.
std::vector<Variation> read_variations(const LabSheet& sheet);
std::vector<Mistake> read_mistakes(const LabSheet& sheet);

} // namespace raylab
