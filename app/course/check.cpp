// raylab check LAB [TASK]: NOT IMPLEMENTED, WAITS, WRONG or PASS for each task, in seconds.
#include "app/course/check_run.h"
#include "app/course/commands.h"
#include "app/course/marks_of.h"
#include "common/cli/files.h"
#include "common/load/suggest.h"
#include "grader/course/contains.h"
#include "grader/results/formats.h"
#include "grader/results/mark_files.h"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <thread>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

struct CheckOptions {
    std::string lab, task, machine = "plain";
    bool watch = false, json = false;
    std::vector<std::string> writes; // FORMAT:FILE
};

std::vector<std::string> asked_tasks(const LabSheet& sheet, const std::string& task) {
    if (task.empty()) return sheet.task_ids();
    if (!sheet.find(task))
        throw CourseError(fmt::format("lab {} has no task '{}'{}; its tasks are {}", sheet.number,
                                      task, did_you_mean(task, sheet.task_ids()),
                                      listed(sheet.task_ids())));
    return {task};
}

// The files below a folder and their times, at a moment. Files come and go while an editor saves.
struct Snapshot {
    fs::file_time_type taken = fs::file_time_type::clock::now();
    std::map<fs::path, fs::file_time_type> times;

    explicit Snapshot(const fs::path& folder) {
        std::error_code error;
        for (fs::recursive_directory_iterator entry(folder, error), end; entry != end;
             entry.increment(error))
            if (const auto time = entry->last_write_time(error); !error)
                times[entry->path()] = time;
    }
};

// Waits until a file in the folder has another time than before. An older time is a change too: a
// file that was copied back from a backup has the backup's time. Ninja builds again only what has a
// later time, so such a file gets the present time.
void wait_for_change(const fs::path& folder, const Snapshot& before) {
    Snapshot now(folder);
    for (; now.times == before.times; now = Snapshot(folder))
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
    std::error_code gone_again;
    for (const auto& [file, time] : now.times) {
        const auto was = before.times.find(file);
        if ((was == before.times.end() || was->second != time) && time < before.taken)
            fs::last_write_time(file, now.taken, gone_again);
    }
}

// Whatever happens, the files say it: platforms see nothing else.
CheckReport check_and_write(const Tree& tree, const LabSheet& sheet,
                            const std::vector<std::string>& ids, const CheckOptions& options) {
    const MarkFiles files(options.writes);
    files.write(no_marks(sheet, ids, "the grader was stopped before it was done"));
    try {
        const CheckReport report =
            check_tasks(tree, sheet, ids, options.machine == "watch" ? 20 : 1,
                        [&](const CheckReport& so_far) { files.write(marks_of(so_far, ids)); });
        files.write(marks_of(report, ids));
        return report;
    } catch (const std::exception& error) {
        files.write(no_marks(sheet, ids, error.what()));
        throw;
    }
}

ExitCode run_check(const Tree& tree, const CheckOptions& options) {
    for (;;) {
        const LabSheet sheet = find_lab(tree.root, options.lab);
        const Snapshot before(sheet.path());
        const CheckReport report =
            check_and_write(tree, sheet, asked_tasks(sheet, options.task), options);
        if (options.json)
            fmt::print("{}\n", to_json(report));
        else
            fmt::print("{}", to_text(report));
        if (!options.watch) return report.passed() ? ExitCode::success : ExitCode::judged_failed;
        fmt::print("watching labs/{}; Ctrl-C ends\n\n", sheet.folder);
        std::fflush(stdout);
        wait_for_change(sheet.path(), before);
    }
}

} // namespace

Run add_check(CLI::App& app, const Tree& tree) {
    auto options = std::make_shared<CheckOptions>();
    app.description("Build a lab and test its tasks: NOT IMPLEMENTED, WAITS, WRONG or PASS.");
    app.add_option("LAB", options->lab, "lab: 01, 02, ... or its folder's name")->required();
    app.add_option("TASK", options->task, "one task, such as 2.3 (default: all)");
    app.add_flag("--watch", options->watch, "check again whenever a file of the lab changes");
    app.add_flag("--json", options->json, "print a JSON object");
    app.add_option("--write", options->writes,
                   "FORMAT:FILE, a file of marks, may be given again; formats: " +
                       fmt::format("{}", fmt::join(mark_formats(), ", ")))
        ->allow_extra_args(false);
    app.add_option(
           "--machine", options->machine,
           "plain, or watch: looks at every load and store, slower (the script chooses the build)")
        ->check(CLI::IsMember({"plain", "watch"}))
        ->capture_default_str();
    app.footer("Examples:\n  raylab check 02\n  raylab check 02 2.3 --watch\n"
               "  raylab check 03 --machine watch    races and unwritten memory are wrong, too\n"
               "  raylab check 02 --write gradescope:results.json --write junit:marks.xml\n"
               "Exit code 0: all tasks asked for pass; 1: not all, or the lab does not compile;\n"
               "3: a test did not run, and nothing is said about the lab.");
    return [options, tree] { return run_check(tree, *options); };
}

} // namespace raylab::app
