// raylab bench: speed against error, labs and other renderers in turns, every image judged.
#include "grader/bench/bench.h"
#include "app/bench_lab.h"
#include "app/bench_peers.h"
#include "app/commands.h"
#include "app/interrupted.h"
#include "app/judged_scene.h"
#include "app/rare_cases.h"
#include "common/cli/files.h"
#include "common/cli/interrupt.h"
#include "common/cli/progress.h"
#include "grader/bench/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <set>

namespace raylab::app {

namespace {

using namespace bench;

struct BenchOptions {
    std::vector<std::string> scenes = {"cornell_peers", "cornell_peers_spheres"}, labs, peers;
    std::string baseline, against, size, folder = "out/bench";
    Plan plan;
    double target = 0.01;
    PeerSettings peer;
    MachineSettings machine;
    bool json = false, rare_cases = false;
};

bool wants(const BenchOptions& options, const std::string& peer) {
    const auto named = [&](const std::string& name) {
        return std::find(options.peers.begin(), options.peers.end(), name) != options.peers.end();
    };
    return named("all") || named(peer) || (named("mitsuba") && peer.starts_with("mitsuba_"));
}

void check_peers(const std::vector<std::string>& peers) {
    std::set<std::string> known(peer_names().begin(), peer_names().end());
    known.insert({"mitsuba", "all", "none"});
    for (const std::string& name : peers)
        if (!known.contains(name))
            throw UsageError(
                fmt::format("there is no peer '{}'; the peers are {}", name, joined(known, ", ")));
}

// Sorts and checks the options before anything is rendered.
void check_options(BenchOptions& options) {
    std::vector<int>& spp = options.plan.spp;
    std::sort(spp.begin(), spp.end());
    spp.erase(std::unique(spp.begin(), spp.end()), spp.end());
    if (spp.size() < 2)
        throw UsageError("--spp needs two different numbers: what a sample costs is told from "
                         "start-up by the difference, like --spp 4,16");
    check_peers(options.peers);
    if (options.labs.empty())
        for (const Lab& lab : labs()) options.labs.push_back(lab.number);
    for (std::string& name : options.labs) name = find_lab(name).number;
    if (options.rare_cases) find_lab("03");
    if (options.baseline.empty()) options.baseline = options.labs.front();
    for (const Lab& lab : labs())
        if (options.baseline == lab.folder) options.baseline = lab.number;
    const auto& peers = peer_names();
    const bool is_lab =
        std::find(options.labs.begin(), options.labs.end(), options.baseline) != options.labs.end();
    const bool is_peer = std::find(peers.begin(), peers.end(), options.baseline) != peers.end() &&
                         wants(options, options.baseline);
    if (!is_lab && !is_peer)
        throw UsageError(fmt::format("--baseline '{}' does not take part: it must be one of the "
                                     "labs ({}) or of the peers asked for",
                                     options.baseline, joined(options.labs, ", ")));
    if (options.machine.threads == 0) options.machine.threads = this_machine().cores;
    options.peer.threads = options.machine.threads;
    options.peer.folder = options.folder + "/peers";
}

// The reference if it was made of this scene and film; else nothing, and `why_not` says the reason.
std::optional<Image> reference_for(const Scene& scene, std::string& why_not) {
    try {
        Image reference = load_reference(scene);
        if (reference.width == scene.camera.width && reference.height == scene.camera.height)
            return reference;
        why_not =
            fmt::format("the reference of {} is {} x {} and the film {} x {}", scene.name,
                        reference.width, reference.height, scene.camera.width, scene.camera.height);
    } catch (const UsageError& error) {
        why_not = error.what();
    }
    return {};
}

// Labs first, then peers. A peer that cannot take part becomes a row in `absent` that says why.
std::vector<Contestant> contestants_for(const BenchOptions& options, const Scene& scene,
                                        std::vector<Row>& absent) {
    std::vector<Contestant> result;
    for (const std::string& lab : options.labs)
        result.push_back(lab_contestant(find_lab(lab), scene, options.machine));
    for (const std::string& peer : peer_names()) {
        if (!wants(options, peer)) continue;
        try {
            result.push_back(peer_contestant(peer, scene, options.peer));
        } catch (const ContestantError& error) {
            Row row;
            row.name = peer;
            row.failure = error.what();
            absent.push_back(row);
        }
    }
    return result;
}

SceneResult bench_scene(const BenchOptions& options, const EvaluateOptions& how,
                        const Scene& scene) {
    SceneResult result;
    result.name = scene.name;
    result.title = scene.title;
    result.hash = scene.hash;
    result.width = scene.camera.width;
    result.height = scene.camera.height;
    result.max_depth = scene.render.max_depth;
    std::string why_not;
    const std::optional<Image> reference = reference_for(scene, why_not);
    result.truth =
        reference
            ? fmt::format("Errors are measured from the reference of {} spp, its own variance "
                          "taken out.",
                          reference->provenance.spp)
            : fmt::format(
                  "Errors come from pairs of seeds, since {}; images are judged against {}.",
                  why_not, find_lab(options.labs.front()).folder);
    std::vector<Row> absent;
    const std::vector<Contestant> contestants = contestants_for(options, scene, absent);
    const int runs = how.plan.rounds * static_cast<int>(how.plan.spp.size() * contestants.size());
    Progress progress("bench " + scene.name, runs, "runs", 1);
    const std::vector<Turns> turns =
        take_turns(contestants, how.plan, [&](int done) { progress.update(done); });
    result.rows = evaluate(turns, reference ? &*reference : nullptr, how);
    result.rows.insert(result.rows.end(), absent.begin(), absent.end());
    return result;
}

std::string command_line(const BenchOptions& options) {
    std::string command =
        fmt::format("raylab bench {} --labs {} --spp {} --repeats {} --threads {}",
                    joined(options.scenes, " "), joined(options.labs, ","),
                    joined(options.plan.spp, ","), options.plan.rounds, options.machine.threads);
    command +=
        fmt::format(" --peers {} --baseline {}", joined(options.peers, ","), options.baseline);
    if (!options.size.empty()) command += " --size " + options.size;
    if (!options.against.empty()) command += " --against " + options.against;
    if (options.rare_cases) command += " --rare-cases";
    return command;
}

void print(const Bench& bench, const std::string& folder) {
    fmt::print("{}\n", to_string(bench.machine));
    for (const SceneResult& scene : bench.scenes) fmt::print("\n{}", to_table(scene));
    if (bench.against) fmt::print("\n{}", to_table(*bench.against));
    if (!bench.rare_cases.empty()) fmt::print("\nRare cases. {}", rare_case_header());
    for (const RareCaseRow& row : bench.rare_cases) fmt::print("{}", to_table(row));
    for (const std::string& note : bench.notes) fmt::print("\n{}\n", note);
    fmt::print("\n[ ] holds the true median with {:.1f} % probability; see {}/bench.html\n",
               100 * interval_coverage(bench.options.plan.rounds), folder);
}

ExitCode run_bench(BenchOptions options) try {
    check_options(options);
    prepare_output(options.folder + "/bench.html");
    std::optional<nlohmann::json> other;
    if (!options.against.empty()) other = parse_bench(read_file(options.against), options.against);
    const SceneChanges changes = film_size(options.size);
    std::vector<Scene> scenes; // all are loaded before the first is rendered
    for (const std::string& name : options.scenes)
        scenes.push_back(load_changed_scene(name, changes));

    Bench bench;
    bench.machine = this_machine();
    bench.command = command_line(options);
    bench.options = {options.plan, options.baseline, options.target};
    bench.threads = options.machine.threads;
    std::mutex mutex; // guards the results that are finished
    const auto work = [&] {
        for (const Scene& scene : scenes) {
            SceneResult result = bench_scene(options, bench.options, scene);
            const std::lock_guard lock(mutex);
            bench.scenes.push_back(std::move(result));
            if (interrupted()) return;
        }
        if (!options.rare_cases) return;
        std::vector<RareCaseRow> rows = measure_rare_cases(
            options.machine, options.plan.rounds, [](const RareCaseRow&) {}); // shown with the rest
        const std::lock_guard lock(mutex);
        bench.rare_cases = std::move(rows);
    };
    const KeepsWork keeping;
    run_interruptibly(work);
    if (interrupted())
        end_interrupted([&] {
            const std::lock_guard lock(mutex);
            if (bench.scenes.empty())
                return say_interrupted(" before the first scene was measured: nothing was written");
            write_bench(bench, options.folder);
            if (!options.json) print(bench, options.folder);
            say_interrupted(fmt::format(": '{}/bench.html' has {} of {} scenes", options.folder,
                                        bench.scenes.size(), scenes.size()));
        });
    if (other) bench.against = compare_runs(to_json(bench), *other, options.against);
    write_bench(bench, options.folder);
    if (options.json)
        fmt::print("{}\n", to_json(bench).dump(2, ' ', false,
                                               nlohmann::ordered_json::error_handler_t::replace));
    else
        print(bench, options.folder);
    bool measured = true; // false if a scene has no contestant that ran
    for (const SceneResult& scene : bench.scenes) {
        bool ran = false;
        for (const Row& row : scene.rows) {
            if (row.failure.empty() && !row.agrees) return ExitCode::judged_failed;
            ran = ran || row.failure.empty();
        }
        measured = measured && ran;
    }
    return measured ? ExitCode::success : ExitCode::tool_failed;
} catch (const AgainstError& error) {
    throw UsageError(error.what());
}

} // namespace

Run add_bench(CLI::App& app) {
    auto options = std::make_shared<BenchOptions>();
    options->peers = {"all"};
    app.description("Measure speed against error: labs and other renderers take turns, every image "
                    "is judged, and only images that agree get a ratio.");
    app.add_option("SCENES", options->scenes, "scenes")->capture_default_str();
    app.add_option("--labs", options->labs, "labs that take part (default: all)")->delimiter(',');
    app.add_option("--peers", options->peers,
                   "cycles, mitsuba_llvm, mitsuba_scalar, mitsuba (both), all or none; "
                   "those that are not installed are left out, with a word")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--baseline", options->baseline,
                   "whom ratios refer to (default: the first lab)");
    app.add_option("--spp", options->plan.spp, "samples a pixel, at least two numbers")
        ->delimiter(',')
        ->check(CLI::Range(1, max_samples))
        ->capture_default_str();
    app.add_option("--repeats", options->plan.rounds, "rounds")
        ->check(CLI::Range(5, 1000))
        ->capture_default_str();
    app.add_option("--size", options->size, "film, WIDTHxHEIGHT (default: the scene's)");
    app.add_option("--target", options->target, "relMSE that the time is told for")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--seed", options->plan.first_seed, "seed of the first run")
        ->capture_default_str();
    app.add_option("--against", options->against, "bench.json of another commit, to compare with");
    app.add_option("--python", options->peer.python, "python that has mitsuba")
        ->capture_default_str();
    app.add_option("--blender", options->peer.blender, "program")->capture_default_str();
    app.add_option("--limit", options->peer.limit, "seconds after which a peer's render is stopped")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("-o,--output", options->folder, "folder for bench.html, bench.json, bench.csv")
        ->capture_default_str();
    app.add_flag("--rare-cases", options->rare_cases,
                 "also where a wavefront gains nothing: labs 02 and 03 as in `raylab rare-cases`, "
                 "in the page, in bench.json and in rare_cases.csv");
    app.add_flag("--json", options->json, "print bench.json instead of the tables");
    add_machine_options(app, options->machine);
    app.footer("Ctrl-C keeps the scenes that were measured until then.\n"
               "Examples:\n"
               "  raylab bench\n"
               "  raylab bench cornell_peers --size 512x512 --baseline cycles --spp 8,32\n"
               "  raylab bench cornell --peers none --labs 01,02 --repeats 9 -o out/today\n"
               "  raylab bench cornell --peers none --against out/yesterday/bench.json\n"
               "  raylab bench cornell --peers none --labs 02,03 --rare-cases");
    return [options] { return run_bench(*options); };
}

} // namespace raylab::app
