#include "app/course/marks_of.h"

#include "grader/course/blank_marks.h"

#include <fmt/format.h>

#include <regex>

namespace raylab::app {

namespace {

MarkVerdict verdict_of(TaskVerdict verdict) {
    switch (verdict) {
    case TaskVerdict::not_implemented:
        return MarkVerdict::not_implemented;
    case TaskVerdict::waits:
        return MarkVerdict::not_run; // its tests ended at the stub of another task
    case TaskVerdict::wrong:
        return MarkVerdict::wrong;
    case TaskVerdict::pass:
        return MarkVerdict::pass;
    }
    return MarkVerdict::not_run;
}

// "labs/02_iterative/path.h:41:7: error": where a text first names a file of the lab.
void set_place(Mark& mark, const std::string& text) {
    static const std::regex place(R"((labs/[^\s:]+):([0-9]+))");
    std::smatch found;
    if (!std::regex_search(text, found, place)) return;
    mark.file = found[1];
    mark.line = std::stoi(found[2]);
}

void judge(Mark& mark, const TaskResult& result) {
    mark.verdict = verdict_of(result.verdict);
    mark.seconds = result.seconds;
    for (const Stub& stub : result.stubs)
        mark.reasons.push_back(result.before(stub) + stub.sentence());
    if (!result.stubs.empty()) set_place(mark, result.stubs.front().place);
    mark.reasons.insert(mark.reasons.end(), result.facts.begin(), result.facts.end());
}

} // namespace

Marks marks_of(const CheckReport& report, const std::vector<std::string>& ids) {
    Marks marks = blank_marks(report.sheet, ids, "raylab check");
    marks.seconds = report.build_seconds + report.test_seconds;
    marks.compiler = report.compiler_errors;
    for (Mark& mark : marks.tasks) {
        for (const TaskResult& result : report.results)
            if (result.task.id == mark.id) judge(mark, result);
        if (marks.compiler.empty()) continue;
        mark.verdict = MarkVerdict::compile_error;
        mark.reasons = {"the lab does not compile: " + first_error(marks.compiler), marks.compiler};
        set_place(mark, marks.compiler);
    }
    return marks;
}

Marks no_marks(const LabSheet& sheet, const std::vector<std::string>& ids,
               const std::string& trouble) {
    Marks marks = blank_marks(sheet, ids, "raylab check");
    marks.trouble = trouble;
    return marks;
}

} // namespace raylab::app
