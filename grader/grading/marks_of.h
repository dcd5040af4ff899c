// From what was found to marks: which verdict has which name.
#pragma once

#include "grader/course/verdict.h"
#include "grader/grading/grade.h"

namespace raylab::grading {

// The submission was not built: the same for each task.
void mark_unbuilt(Marks& marks, const sandbox::Outcome& outcome, const std::string& compiler_errors,
                  const sandbox::Limits& limits);

void mark_all(Marks& marks, MarkVerdict verdict, const std::string& reason);

// What its tests say of a task. bad_end: how one of them ended, if not by itself; forged: one said
// that all was well, and the witness did not.
void mark_task(Marks& marks, const TaskResult& result, std::optional<sandbox::End> bad_end,
               bool forged);

// Stubs and facts of a task, once all tasks are known.
void set_reasons(Marks& marks, const TaskResult& result);

bool all_pass(const Marks& marks, const std::vector<std::string>& tasks);

// Takes the points of the tasks of a picture that is not right.
void mark_picture(Marks& marks, const JudgedPicture& judged);

} // namespace raylab::grading
