// raylab check LAB [TASK]: NOT IMPLEMENTED, WRONG or PASS for each task, in seconds.
#include "app/course/check_run.h"
#include "app/course/commands.h"
#include "common/scene/suggest.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

struct CheckOptions {
    std::string lab, task;
    bool watch = false, json = false;
};

std::vector<std::string> asked_tasks(const LabSheet& sheet, const std::string& task) {
    if (task.empty()) return sheet.task_ids();
    if (!sheet.find(task))
        throw CourseError(fmt::format("lab {} has no task '{}'{}; its tasks are {}", sheet.number,
                                      task, did_you_mean(task, sheet.task_ids()),
                                      listed(sheet.task_ids())));
    return {task};
}

// The newest change below the lab's folder. Files come and go while an editor saves.
fs::file_time_type last_change(const fs::path& folder) {
    fs::file_time_type newest = fs::file_time_type::min();
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; entry != end;
         entry.increment(error))
        if (const auto time = entry->last_write_time(error); !error)
            newest = std::max(newest, time);
    return newest;
}

void wait_for_change(const fs::path& folder, fs::file_time_type since) {
    while (last_change(folder) <= since)
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
}

ExitCode run_check(const Tree& tree, const CheckOptions& options) {
    for (;;) {
        const LabSheet sheet = find_lab(tree.root, options.lab);
        const auto before = last_change(sheet.path());
        const CheckReport report = check_tasks(tree, sheet, asked_tasks(sheet, options.task));
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
    app.description("Build a lab and test its tasks: NOT IMPLEMENTED, WRONG or PASS.");
    app.add_option("LAB", options->lab, "lab: 01, 02, ... or its folder's name")->required();
    app.add_option("TASK", options->task, "one task, such as 2.3 (default: all)");
    app.add_flag("--watch", options->watch, "check again whenever a file of the lab changes");
    app.add_flag("--json", options->json, "print a JSON object");
    app.footer("Examples:\n  raylab check 02\n  raylab check 02 2.3 --watch\n"
               "Exit code 0: all tasks asked for pass; 1: not all, or the lab does not compile.");
    return [options, tree] { return run_check(tree, *options); };
}

} // namespace raylab::app
