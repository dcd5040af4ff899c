#include "grader/class/run_class.h"

#include "common/cli/files.h"
#include "common/cli/joined_threads.h"
#include "common/cli/process.h"
#include "grader/results/marks_json.h"
#include "grader/results/text.h"
#include "grader/submissions/source_text.h"
#include "grader/submissions/submission_error.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <exception>
#include <set>

namespace raylab {

namespace fs = std::filesystem;

namespace {

// The marks that a run has left, or why it has left none.
void read_run(Graded& graded, const ProcessResult& process, const fs::path& run,
              const std::string& lab) {
    const bool has_judged =
        !process.timed_out && (process.exit_code == 0 || process.exit_code == 1);
    if (!has_judged)
        graded.trouble = fmt::format(
            "the grader {}: {}", process.timed_out ? "did not end" : "failed", why_failed(process));
    if (!has_judged && process.exit_code != static_cast<int>(ExitCode::tool_failed)) return;
    try {
        const Marks marks = read_marks_json(
            read_sent_file(run / "marks.json", "marks.json", most_of_marks_json), "marks.json");
        if (marks.lab != lab)
            graded.trouble = fmt::format("marks.json is of lab {}, not of {}", marks.lab, lab);
        else if (!marks.trouble.empty())
            graded.trouble = marks.trouble;
        if (graded.trouble.empty()) graded.marks = marks;
    } catch (const std::exception& error) { // none, cut off, of another version
        if (graded.trouble.empty()) graded.trouble = error.what();
    }
}

Graded grade_one(const ClassGrader& grader, const Journal::Work& work) {
    const fs::path run = run_of(grader.folder, work.run);
    std::vector<std::string> command = grader.program;
    for (const std::string& word :
         {grader.lab, files_of(grader.folder, work.hash).string(), std::string("-o"), run.string()})
        command.push_back(word);
    fs::create_directories(run);
    const ProcessResult process = run_process(command, {grader.limit_seconds});
    Graded graded;
    graded.seconds = process.seconds;
    graded.when = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    read_run(graded, process, run, grader.lab);
    graded.trouble = clean_utf8(shortened(graded.trouble, 2000));
    return graded;
}

void remove_others(const fs::path& folder, const std::vector<std::string>& wanted) {
    const std::set<std::string> names(wanted.begin(), wanted.end());
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
        if (names.count(entry.path().filename().string()) == 0) fs::remove_all(entry.path());
}

} // namespace

fs::path files_of(const fs::path& folder, const std::string& hash) {
    return folder / "submissions" / hash;
}

fs::path run_of(const fs::path& folder, const std::string& run) { return folder / "runs" / run; }

void run_class(Journal& journal, Set set, const ClassGrader& grader,
               const std::function<void(int done)>& after_each) {
    std::atomic<int> done = 0;
    std::atomic<bool> failed = false;
    std::exception_ptr error;
    std::mutex mutex;
    const auto work = [&] {
        try {
            while (!failed) {
                const auto next = journal.take(set);
                if (!next) return;
                journal.finish(set, *next, grade_one(grader, *next));
                after_each(++done);
            }
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failed.exchange(true)) error = std::current_exception();
        }
    };
    {
        JoinedThreads threads;
        for (int i = 0; i < std::max(1, grader.jobs); ++i) threads.start(work);
    }
    if (error) std::rethrow_exception(error);
}

void tidy(const Journal& journal, const fs::path& folder) {
    remove_others(folder / "runs", journal.runs());
    remove_others(folder / "submissions", journal.hashes());
}

} // namespace raylab
