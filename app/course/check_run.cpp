// Build what changed, run the tests, say for each task what they found.
#include "app/course/check_run.h"

#include "common/cli/process.h"
#include "common/cli/progress.h"
#include "grader/course/compiler_errors.h"
#include "grader/course/needs_first.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

constexpr double build_limit_seconds = 1800; // a first build, on a slow machine

// Ninja's last "[12/42] ..." as a progress line.
class BuildProgress {
  public:
    void operator()(const std::string& output) {
        const std::size_t line = output.rfind("\n[", output.size() - 1);
        const std::size_t at = line == output.npos ? 0 : line + 1;
        int done = 0, of = 0;
        char close = 0; // stays 0 if the line is not complete yet
        if (std::sscanf(output.c_str() + at, "[%d/%d%c", &done, &of, &close) != 3) return;
        if (!progress_) progress_.emplace("building", of, "files", 1);
        progress_->update(done, of); // Ninja may find more to do on its way
    }

  private:
    std::optional<Progress> progress_;
};

ProcessResult build_target(const Tree& tree, const std::string& target) {
    return run_process({"cmake", "--build", tree.build.string(), "--target", target},
                       {build_limit_seconds, tree.root,
                        [progress = std::make_shared<BuildProgress>()](const std::string& output) {
                            (*progress)(output);
                        }});
}

// Whether the build failed because of the lab's sources, and not because of the machine that
// compiles them.
bool is_the_labs(const ProcessResult& build, const std::string& errors, const LabSheet& sheet) {
    if (build.exit_code < 0) return false; // not started, too slow, or ended by a signal
    for (const char* machine : {"No space left on device", "internal compiler error",
                                "Killed signal terminated", "annot allocate memory"})
        if (build.output.find(machine) != std::string::npos) return false;
    return errors.find("labs/" + sheet.folder) != std::string::npos;
}

} // namespace

bool CheckReport::passed() const {
    return compiler_errors.empty() && !results.empty() &&
           std::all_of(results.begin(), results.end(),
                       [](const TaskResult& r) { return r.verdict == TaskVerdict::pass; });
}

CheckReport check_tasks(const Tree& tree, const LabSheet& sheet,
                        const std::vector<std::string>& ids, double patience,
                        const std::function<void(const CheckReport&)>& after_task) {
    CheckReport report{sheet, "", {}, 0, 0};
    const ProcessResult build = build_target(tree, sheet.test_target);
    report.build_seconds = build.seconds;
    if (!build.succeeded()) {
        report.compiler_errors = compiler_errors(build.output, tree.root);
        if (!is_the_labs(build, report.compiler_errors, sheet))
            throw std::runtime_error(fmt::format("the build failed outside the lab, {}:\n{}",
                                                 why_failed(build), report.compiler_errors));
        return report;
    }
    const fs::path program = tree.build / "labs" / sheet.folder / sheet.test_target;
    Progress progress("checking", static_cast<int>(ids.size()), "tasks", 1);
    for (const std::string& id : ids) {
        report.results.push_back(judge_task(sheet, *sheet.find(id), program, patience));
        report.test_seconds += report.results.back().seconds;
        if (after_task) after_task(report);
        progress.update(static_cast<int>(report.results.size()));
    }
    say_what_is_needed_first(report.results);
    return report;
}

std::string to_text(const CheckReport& report) {
    if (!report.compiler_errors.empty())
        return fmt::format("{}lab {} does not compile: no task was tested\n",
                           report.compiler_errors, report.sheet.number);
    std::string text;
    int points = 0, of = 0;
    for (const TaskResult& result : report.results) {
        points += result.points(), of += result.task.points;
        text += fmt::format("{:15}  {}  {} ({}/{} points)\n", name(result.verdict), result.task.id,
                            result.task.title, result.points(), result.task.points);
        for (const Stub& stub : result.stubs)
            text += fmt::format("    {}{}\n", result.before(stub), stub.sentence());
        for (const std::string& fact : result.facts) text += fmt::format("    {}\n", fact);
        for (const std::string& line : result.said) text += fmt::format("    | {}\n", line);
        if (result.verdict != TaskVerdict::pass)
            text += fmt::format("    read on: labs/{}/README.md, \"{}\"\n", report.sheet.folder,
                                result.task.hints);
    }
    return text + fmt::format("{} of {} points; built in {}, tested in {}\n", points, of,
                              human_duration(report.build_seconds),
                              human_duration(report.test_seconds));
}

std::string to_json(const CheckReport& report) {
    nlohmann::ordered_json tasks = nlohmann::ordered_json::array();
    for (const TaskResult& result : report.results) {
        nlohmann::ordered_json stubs = nlohmann::ordered_json::array();
        for (const Stub& stub : result.stubs)
            stubs.push_back(
                {{"task", stub.task}, {"function", stub.function}, {"place", stub.place}});
        tasks.push_back({{"id", result.task.id},
                         {"title", result.task.title},
                         {"verdict", name(result.verdict)},
                         {"points", result.points()},
                         {"of_points", result.task.points},
                         {"tests", result.tests},
                         {"tests_passed", result.passed},
                         {"not_implemented", stubs},
                         {"facts", result.facts},
                         {"said", result.said},
                         {"seconds", result.seconds}});
    }
    const nlohmann::ordered_json json = {{"lab", report.sheet.number},
                                         {"compiles", report.compiler_errors.empty()},
                                         {"compiler_errors", report.compiler_errors},
                                         {"passed", report.passed()},
                                         {"tasks", tasks},
                                         {"build_seconds", report.build_seconds},
                                         {"test_seconds", report.test_seconds}};
    return json.dump(2);
}

} // namespace raylab::app
