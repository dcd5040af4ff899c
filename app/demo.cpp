// raylab demo: every lab renders the bundled scenes, every image is judged, one page shows it all.
#include "app/commands.h"
#include "app/interrupted.h"
#include "app/judged_scene.h"
#include "common/cli/files.h"
#include "common/cli/interrupt.h"
#include "common/cli/progress.h"
#include "common/load/load.h"
#include "grader/judge/json.h"
#include "grader/report/report.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <mutex>
#include <optional>
#include <thread>

namespace raylab::app {

namespace {

struct DemoOptions {
    std::string folder = "out/demo";
    std::vector<std::string> scenes;
    std::uint32_t seed = 1;
    MachineSettings machine;
    bool json = false;
};

// All 0 if the image could not be judged.
Metrics metrics_of(const JudgedScene& judged) {
    return judged.judgement.verdict.measured.value_or(Measures{}).metrics;
}

ReportEntry report_entry(const JudgedScene& judged, const Image& reference) {
    const IndependentResult& judgement = judged.judgement;
    const Metrics metrics = metrics_of(judged);
    ReportEntry entry;
    entry.scene = judged.scene;
    entry.title = judged.title;
    entry.reason = judged.reason;
    entry.lab = judged.lab;
    entry.passed = judged.passed;
    entry.verdict = judgement.verdict;
    entry.details = {{"reference", judgement}};
    for (const ExpectationResult& expectation : judged.expectations)
        entry.checks.push_back({expectation.met, expectation.sentence, {}});
    if (judged.same_paths) {
        entry.checks.push_back(judged.same_paths->verdict);
        entry.details["same_paths"] = *judged.same_paths;
    }
    entry.seconds = judged.seconds;
    const double rays = static_cast<double>(judged.ledger.rays()) / judged.ledger.seconds;
    entry.facts = {{"samples a pixel", std::to_string(judged.image.provenance.spp)},
                   {"tracing", human_duration(judged.seconds)},
                   {"speed", human_count(rays) + "rays/s"},
                   {"relMSE", fmt::format("{:.2g}", metrics.rel_mse)},
                   {"mean error", fmt::format("{:+.3f} %", 100 * metrics.rel_error)}};
    entry.image = judged.image;
    entry.reference = reference;
    for (const BounceCounts& bounce : judged.ledger.bounces)
        if (bounce.lanes > 0) entry.lanes_alive.push_back(lanes_alive(bounce));
    return entry;
}

std::string machine_line() {
    return fmt::format("{} host threads, compiler {}, {:%Y-%m-%d}",
                       std::thread::hardware_concurrency(), __VERSION__,
                       fmt::localtime(std::time(nullptr)));
}

void print_row(const JudgedScene& judged) {
    fmt::print("{:6} {:20} {:14} {:>5} spp {:>9} {:>9.2g}  {}\n", judged.passed ? "PASS" : "FAIL",
               judged.scene, judged.lab, judged.image.provenance.spp,
               human_duration(judged.seconds), metrics_of(judged).rel_mse,
               judged.passed ? "" : judged.judgement.verdict.sentence);
    for (const ExpectationResult& expectation : judged.expectations)
        if (!expectation.met) fmt::print("       {}\n", expectation.sentence);
    if (judged.same_paths && !judged.same_paths->verdict.passed)
        fmt::print("       {}\n", judged.same_paths->verdict.sentence);
}

// The results that the demo has finished so far.
struct Finished {
    std::mutex mutex;
    Report report;
    bool passed = true;
};

void judge_all(const DemoOptions& options, Progress& progress, Finished& finished) {
    int done = 0;
    for (const std::string& name : options.scenes) {
        const Scene scene = load_scene(find_scene(name));
        const Image reference = load_reference(scene);
        std::optional<JudgedScene> before;
        for (const Lab& lab : labs()) {
            if (interrupted()) return;
            JudgedScene judged = judge_scene(lab, scene, reference, options.machine, options.seed);
            if (before) judge_against(judged, *before);
            progress.clear();
            const std::lock_guard lock(finished.mutex);
            finished.passed = finished.passed && judged.passed;
            if (!options.json) print_row(judged);
            finished.report.entries.push_back(report_entry(judged, reference));
            before = std::move(judged);
            progress.update(++done);
        }
    }
}

void write_demo(const DemoOptions& options, const Report& report) {
    write_report(report, options.folder);
    if (options.json) fmt::print("{}\n", report_json(report).dump(2));
}

ExitCode run_demo(const DemoOptions& options) {
    prepare_output(options.folder + "/report.html");
    Finished finished;
    finished.report = {"raylab demo", machine_line(), "raylab demo", {}};
    if (!options.json)
        fmt::print("{:6} {:20} {:14} {:>9} {:>9} {:>9}\n", "", "scene", "lab", "samples", "tracing",
                   "relMSE");
    const std::size_t renders = options.scenes.size() * labs().size();
    Progress progress("demo", static_cast<int>(renders), "renders", 1);
    const KeepsWork keeping;
    run_interruptibly([&] { judge_all(options, progress, finished); }, [&] { progress.tick(); });
    const std::lock_guard lock(finished.mutex);
    const Report& report = finished.report;
    progress.clear();
    if (interrupted())
        end_interrupted([&] {
            if (report.entries.empty())
                return say_interrupted(" before the first image was judged: nothing was written");
            write_demo(options, report);
            say_interrupted(fmt::format(": '{}/report.html' has {} of {} images", options.folder,
                                        report.entries.size(), renders));
        });
    write_demo(options, report);
    if (!options.json)
        fmt::print("{} in {}; see {}/report.html\n",
                   finished.passed ? "all passed" : "NOT all passed",
                   human_duration(progress.seconds()), options.folder);
    return finished.passed ? ExitCode::success : ExitCode::judged_failed;
}

} // namespace

Run add_demo(CLI::App& app) {
    auto options = std::make_shared<DemoOptions>();
    app.description("Render the bundled scenes with every lab, judge each image, write a report.");
    app.add_option("SCENES", options->scenes, "scenes (default: all bundled)");
    app.add_option("-o,--output", options->folder, "folder for report.html and results.json")
        ->capture_default_str();
    app.add_option("--seed", options->seed, "seed of the first replicate")->capture_default_str();
    app.add_flag("--json", options->json, "print results.json instead of the table");
    add_machine_options(app, options->machine);
    app.footer("Ctrl-C writes the report of the images that were judged until then.\n"
               "Examples:\n  raylab demo\n  raylab demo cornell whitted -o out/two");
    return [options] {
        if (options->scenes.empty()) options->scenes = bundled_scenes();
        if (options->scenes.empty() || labs().empty())
            throw std::runtime_error("this tree has no scenes or no labs: nothing was judged");
        return run_demo(*options);
    };
}

} // namespace raylab::app
