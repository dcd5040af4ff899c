// marks.json: Marks as raylab keeps them, written by whatever grades and read by whatever collects.
//
//     { "format": "raylab marks", "version": 1, "lab": "02_iterative", "title": "...",
//       "grader": "raylab 0.1", "sandbox": "...", "seconds": 41.2, "score": 75, "max_score": 100,
//       "verdict": "WRONG_IMAGE", "trouble": "", "compiler": "", "log": "",
//       "missing": [], "ignored": ["notes.txt"],
//       "tasks": [ { "id": "2.1", "title": "...", "verdict": "PASS", "score": 30, "max_score": 30,
//                    "reasons": [], "file": "labs/02_iterative/path.h", "line": 0,
//                    "read_on": "2.1 The loop", "seconds": 1.5 }, ... ] }
//
// `score`, `max_score` of the whole and `verdict` are there for other readers: they follow from
// the tasks, and a file where they do not is refused.
#pragma once

#include "grader/results/marks.h"

#include <stdexcept>
#include <string>
#include <string_view>

namespace raylab {

constexpr int marks_version = 1;

// The largest file that is written, and read: what a submission says is cut to fit.
constexpr std::size_t most_of_marks_json = 4 << 20;

// A complete file, valid UTF-8 whatever bytes a submission has printed.
std::string marks_json(const Marks& marks);

// what() is one sentence: `marks.json:3:14: /tasks/0/verdict: expected ..., found ...`.
struct MarksError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Reads what marks_json() wrote; `file` is its name in errors. Throws MarksError for another
// version, for what is not of this format, and for points that do not follow from the verdicts.
Marks read_marks_json(std::string_view text, const std::string& file);

} // namespace raylab
