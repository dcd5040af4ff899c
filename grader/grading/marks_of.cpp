#include "grader/grading/marks_of.h"

#include "grader/course/contains.h"

#include <fmt/format.h>

#include <regex>

namespace raylab::grading {

namespace {

MarkVerdict verdict_of(sandbox::End end) {
    switch (end) {
    case sandbox::End::time_limit:
        return MarkVerdict::time_limit;
    case sandbox::End::memory_limit:
    case sandbox::End::process_limit:
        return MarkVerdict::memory_limit;
    case sandbox::End::output_limit:
        return MarkVerdict::output_limit;
    case sandbox::End::crashed:
        return MarkVerdict::crash;
    case sandbox::End::exited:
    case sandbox::End::not_started:
        break;
    }
    return MarkVerdict::wrong;
}

Mark* find(Marks& marks, const std::string& id) {
    for (Mark& mark : marks.tasks)
        if (mark.id == id) return &mark;
    return nullptr;
}

// "labs/02_iterative/path.h:41:7: error: ...": the compiler's first error in a file of the lab.
void set_place(Marks& marks, const std::string& text, const std::string& pattern) {
    const std::regex place("(labs/[^\\s:]+):([0-9]+)" + pattern);
    std::smatch found;
    if (!std::regex_search(text, found, place)) return;
    for (Mark& mark : marks.tasks) {
        mark.file = found[1];
        mark.line = std::stoi(found[2]);
    }
}

// A hidden scene's failure says what kind of fault it is, never its data.
std::string sentence_of(const JudgedPicture& judged) {
    const std::string scene =
        judged.hidden
            ? fmt::format("a scene like {} that was made for this submission", judged.picture.scene)
            : judged.picture.scene;
    const std::string options =
        judged.picture.options.empty()
            ? ""
            : fmt::format(" with {}", fmt::join(judged.picture.options, " "));
    const std::string what = judged.hidden && judged.result.verdict == MarkVerdict::wrong_image
                                 ? "the picture differs from the reference"
                                 : judged.result.sentence;
    return fmt::format("{}{}: {}", scene, options, what);
}

} // namespace

void mark_all(Marks& marks, MarkVerdict verdict, const std::string& reason) {
    for (Mark& mark : marks.tasks) {
        mark.verdict = verdict;
        mark.reasons = {reason};
    }
}

void mark_unbuilt(Marks& marks, const sandbox::Outcome& outcome, const std::string& compiler_errors,
                  const sandbox::Limits& limits) {
    marks.compiler = compiler_errors;
    marks.log = outcome.output;
    if (outcome.end == sandbox::End::exited) {
        mark_all(marks, MarkVerdict::compile_error,
                 "the lab does not compile: " + first_error(compiler_errors));
        for (Mark& mark : marks.tasks) mark.reasons.push_back(compiler_errors);
        set_place(marks, compiler_errors, ":[0-9]+: (fatal )?error");
        return;
    }
    const MarkVerdict verdict =
        outcome.end == sandbox::End::crashed ? MarkVerdict::compile_error : verdict_of(outcome.end);
    mark_all(marks, verdict, "while it was compiled: " + sandbox::why(outcome, limits));
}

void mark_task(Marks& marks, const TaskResult& result, std::optional<sandbox::End> bad_end,
               bool forged) {
    Mark& mark = *find(marks, result.task.id);
    mark.seconds = result.seconds;
    switch (result.verdict) {
    case TaskVerdict::not_implemented:
        mark.verdict = MarkVerdict::not_implemented;
        break;
    case TaskVerdict::waits:
        mark.verdict = MarkVerdict::not_run; // its tests ended at the stub of another task
        break;
    case TaskVerdict::wrong:
        mark.verdict = forged    ? MarkVerdict::no_output
                       : bad_end ? verdict_of(*bad_end)
                                 : MarkVerdict::wrong;
        break;
    case TaskVerdict::pass:
        mark.verdict = MarkVerdict::pass;
        break;
    }
    set_reasons(marks, result);
    if (forged && mark.verdict == MarkVerdict::no_output)
        mark.reasons.insert(mark.reasons.begin(),
                            "a test ended the program before the test was over, with exit code 0");
}

void set_reasons(Marks& marks, const TaskResult& result) {
    Mark& mark = *find(marks, result.task.id);
    if (mark.verdict != MarkVerdict::not_implemented && mark.verdict != MarkVerdict::not_run &&
        mark.verdict != MarkVerdict::wrong && !mark.reasons.empty())
        return;
    mark.reasons.clear();
    for (const Stub& stub : result.stubs)
        mark.reasons.push_back(result.before(stub) + stub.sentence());
    mark.reasons.insert(mark.reasons.end(), result.facts.begin(), result.facts.end());
}

bool all_pass(const Marks& marks, const std::vector<std::string>& tasks) {
    return std::all_of(marks.tasks.begin(), marks.tasks.end(), [&](const Mark& mark) {
        return !contains(tasks, mark.id) || mark.verdict == MarkVerdict::pass;
    });
}

void mark_picture(Marks& marks, const JudgedPicture& judged) {
    const PictureResult& result = judged.result;
    const auto take = [&](const std::vector<std::string>& tasks, MarkVerdict verdict,
                          const std::string& reason) {
        for (const std::string& id : tasks) {
            Mark& mark = *find(marks, id);
            if (mark.verdict != MarkVerdict::pass) continue;
            mark.verdict = verdict;
            mark.reasons = {reason};
        }
    };
    if (result.verdict != MarkVerdict::pass)
        take(judged.picture.tasks, result.verdict, sentence_of(judged));
    else if (result.same_paths && !result.same_counts)
        take(judged.picture.counts, MarkVerdict::wrong,
             fmt::format("{}: the ledger's counts are not those of the paths that were drawn",
                         judged.picture.scene));
}

} // namespace raylab::grading
