// raylab bench-rays: rays a second, structures and walks in turns, every answer compared.
#include "app/commands.h"
#include "app/interrupted.h"
#include "app/ray_contestants.h"
#include "app/scene_changes.h"
#include "common/cli/files.h"
#include "common/cli/interrupt.h"
#include "common/cli/progress.h"
#include "common/load/load.h"
#include "common/load/procedural/procedural.h"
#include "common/load/suggest.h"
#include "grader/bench/rays/rays_bench.h"
#include "grader/bench/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <mutex>

namespace raylab::app {

namespace {

using namespace bench;

struct RaysOptions {
    std::vector<std::string> meshes, structures = ray_contestant_names(), kinds;
    std::vector<double> camera;
    std::string size, scaling, triangles = "100..1000000", folder = "out/bench-rays";
    RaceOptions race;
    bool json = false;
};

const std::vector<std::string> default_meshes = {"sphere_flake:100000", "terrain:100000",
                                                 "city:100000"};

void check_words(const char* option, const std::vector<std::string>& words,
                 const std::vector<std::string>& known) {
    for (const std::string& word : words)
        if (std::find(known.begin(), known.end(), word) == known.end())
            throw UsageError(fmt::format("{} '{}'{}: expected {}", option, word,
                                         did_you_mean(word, known), one_of(known)));
}

int triangle_count(const std::string& text) {
    int count = 0, end = 0;
    if (std::sscanf(text.c_str(), "%d%n", &count, &end) != 1 || end != int(text.size()) ||
        count < fewest_procedural_triangles || count > most_procedural_triangles)
        throw UsageError(fmt::format("'{}': expected {} to {} triangles", text,
                                     fewest_procedural_triangles, most_procedural_triangles));
    return count;
}

// "100..3000": 100, 300, 1000, 3000; both ends, and between them 1 and 3 of each decade.
std::vector<int> sizes(const std::string& range) {
    const std::size_t dots = range.find("..");
    if (dots == range.npos)
        throw UsageError(
            fmt::format("--triangles '{}': expected a range, like 100..1000000", range));
    const int first = triangle_count(range.substr(0, dots)),
              last = triangle_count(range.substr(dots + 2));
    if (first >= last)
        throw UsageError(fmt::format("--triangles '{}': expected the smaller number first", range));
    std::vector<int> result = {first};
    for (int decade = fewest_procedural_triangles; decade < last; decade *= 10)
        for (const int n : {decade, 3 * decade})
            if (n > first && n < last) result.push_back(n);
    result.push_back(last);
    return result;
}

// "terrain:10000", a mesh file, or a scene.
RayMesh load(const std::string& name, const RaysOptions& options) {
    const std::size_t colon = name.find(':');
    const std::string ending = ending_of(name);
    RayMesh mesh;
    std::error_code ignored;
    if (colon != name.npos && !std::filesystem::exists(name, ignored)) {
        const std::string kind = name.substr(0, colon);
        check_words("mesh", {kind}, procedural_mesh_names());
        mesh = procedural_ray_mesh(kind, triangle_count(name.substr(colon + 1)), options.race.seed);
    } else if (ending == ".obj" || ending == ".gltf" || ending == ".glb") {
        mesh = load_ray_mesh(name);
    } else {
        return polygons_of(load_scene(find_scene(name)));
    }
    if (!options.camera.empty()) {
        const double* c = options.camera.data();
        const DVec3 position(c[0], c[1], c[2]), look_at(c[3], c[4], c[5]);
        if (position == look_at)
            throw UsageError("--camera: expected two different points, position and look-at");
        mesh.camera = pinhole(position, look_at);
    }
    return mesh;
}

// Sorts and checks the options before anything is built.
void check_options(RaysOptions& options) {
    std::vector<std::string> kind_names;
    for (const RayKind kind : all_ray_kinds) kind_names.push_back(name_of(kind));
    check_words("--structures", options.structures, ray_contestant_names());
    check_words("--rays", options.kinds, kind_names);
    if (!options.kinds.empty()) {
        options.race.kinds.clear();
        for (const RayKind kind : all_ray_kinds)
            if (std::count(options.kinds.begin(), options.kinds.end(), name_of(kind)))
                options.race.kinds.push_back(kind);
    }
    if (!options.scaling.empty()) {
        check_words("--scaling", {options.scaling}, procedural_mesh_names());
        if (!options.meshes.empty())
            throw UsageError("--scaling makes its own meshes: leave the others out");
        for (const int n : sizes(options.triangles))
            options.meshes.push_back(fmt::format("{}:{}", options.scaling, n));
    }
    if (options.size.empty()) options.size = options.scaling.empty() ? "1024x1024" : "256x256";
    if (options.meshes.empty()) options.meshes = default_meshes;
}

// The contestants that are present. For each one that is absent, a note is added to the bench.
std::vector<RayContestant> contestants_for(RaysOptions& options, RaysBench& bench) {
    std::vector<RayContestant> result;
    for (const std::string& name : options.structures) try {
            result.push_back(ray_contestant(name));
        } catch (const ContestantError& error) {
            bench.notes.push_back(fmt::format("{}: {}.", name, error.what()));
        }
    if (result.empty())
        throw UsageError(fmt::format("no structure can take part: {}", joined(bench.notes, " ")));
    const auto is_here = [&](const std::string& name) {
        return std::any_of(result.begin(), result.end(),
                           [&](const RayContestant& c) { return c.name == name; });
    };
    std::string& baseline = options.race.baseline;
    if (baseline.empty()) baseline = is_here("embree") ? "embree" : result.front().name;
    if (!is_here(baseline))
        throw UsageError(fmt::format("--baseline '{}' does not take part: {}", baseline,
                                     bench.notes.empty() ? "it must be one of --structures"
                                                         : joined(bench.notes, " ")));
    return result;
}

std::string command_line(const RaysOptions& options) {
    std::string command = "raylab bench-rays";
    if (options.scaling.empty())
        command += " " + joined(options.meshes, " ");
    else
        command += fmt::format(" --scaling {} --triangles {}", options.scaling, options.triangles);
    command += fmt::format(" --structures {} --baseline {} --size {} --repeats {} --builds {} "
                           "--verify {} --threads {} --seed {}",
                           joined(options.structures, ","), options.race.baseline, options.size,
                           options.race.rounds, options.race.builds, options.race.verify,
                           options.race.threads, options.race.seed);
    if (!options.kinds.empty()) command += " --rays " + joined(options.kinds, ",");
    if (!options.camera.empty()) command += " --camera " + joined(options.camera, ",");
    return command;
}

void print(const RaysBench& bench, const std::string& folder) {
    fmt::print("{}\n", to_string(bench.machine));
    for (const RayRace& race : bench.races)
        fmt::print("\n{}", to_table(race, bench.options.baseline));
    fmt::print("\n{}", to_table(summaries(bench), bench.options.baseline));
    for (const std::string& note : bench.notes) fmt::print("\n{}\n", note);
    fmt::print("\n[ ] holds the true median with {:.1f} % probability; see {}/rays.html\n",
               100 * interval_coverage(bench.options.rounds), folder);
}

ExitCode run_bench_rays(RaysOptions options) try {
    check_options(options);
    prepare_output(options.folder + "/rays.html");
    const SceneChanges film = film_size(options.size);
    RaysBench bench;
    bench.width = *film.width;
    bench.height = *film.height;
    const std::vector<RayContestant> contestants = contestants_for(options, bench);
    bench.machine = this_machine();
    bench.command = command_line(options);
    bench.options = options.race;
    bench.scaling = options.scaling;
    // All meshes are loaded before the first is traced. With --scaling each is made in its turn,
    // since all of them together may not fit in memory.
    std::map<std::string, RayMesh> loaded;
    if (options.scaling.empty())
        for (const std::string& name : options.meshes) loaded[name] = load(name, options);
    std::mutex mutex; // guards the results that are finished
    const auto work = [&] {
        for (const std::string& name : options.meshes) {
            RayMesh mesh = options.scaling.empty() ? loaded.at(name) : load(name, options);
            set_film_size(mesh.camera, bench.width, bench.height);
            const int steps = race_steps(contestants, options.race);
            Progress progress("bench-rays " + mesh.name, steps, "runs", 1);
            int done = 0;
            RayRace result =
                race(mesh, contestants, options.race, [&] { progress.update(++done); });
            const std::lock_guard lock(mutex);
            bench.races.push_back(std::move(result));
            if (interrupted()) return;
        }
    };
    const KeepsWork keeping;
    run_interruptibly(work);
    if (interrupted())
        end_interrupted([&] {
            const std::lock_guard lock(mutex);
            if (bench.races.empty())
                return say_interrupted(" before the first mesh was measured: nothing was written");
            write_rays_bench(bench, options.folder);
            if (!options.json) print(bench, options.folder);
            say_interrupted(fmt::format(": '{}/rays.html' has {} of {} meshes", options.folder,
                                        bench.races.size(), options.meshes.size()));
        });
    write_rays_bench(bench, options.folder);
    if (options.json)
        fmt::print("{}\n", to_json(bench).dump(2));
    else
        print(bench, options.folder);
    for (const RayRace& race : bench.races)
        for (const RayRow& row : race.rows)
            for (const RayCell& cell : row.cells)
                if (!cell.agrees) return ExitCode::judged_failed;
    return ExitCode::success;
} catch (const ContestantError& error) {
    throw UsageError(error.what());
}

} // namespace

Run add_bench_rays(CLI::App& app) {
    auto options = std::make_shared<RaysOptions>();
    app.description("Measure rays a second: structures take turns on the same rays, every answer "
                    "is compared, and only right ones get a ratio.");
    app.add_option("MESHES", options->meshes,
                   "scenes, mesh files (.obj, .gltf, .glb), or procedural meshes KIND:TRIANGLES "
                   "(default: " +
                       joined(default_meshes, " ") + ")");
    app.add_option("--structures", options->structures, "who takes part")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--baseline", options->race.baseline,
                   "whom ratios refer to (default: embree, else the first)");
    app.add_option("--rays", options->kinds,
                   "kinds: primary,shadow,ao,diffuse1,diffuse2 (default: all)")
        ->delimiter(',');
    app.add_option("--size", options->size,
                   "camera rays, WIDTHxHEIGHT (default: 1024x1024; with --scaling 256x256)");
    app.add_option("--camera", options->camera,
                   "X,Y,Z,X,Y,Z: position and look-at, for all meshes but scenes (default: a mesh "
                   "file fills the film from the front)")
        ->delimiter(',')
        ->expected(6);
    app.add_option("--scaling", options->scaling,
                   "a procedural mesh, traced at rising numbers of triangles: " +
                       listed(procedural_mesh_names()));
    app.add_option("--triangles", options->triangles, "range of --scaling, FIRST..LAST")
        ->capture_default_str();
    app.add_option("--repeats", options->race.rounds, "rounds")
        ->check(CLI::Range(5, 1000))
        ->capture_default_str();
    app.add_option("--builds", options->race.builds, "timed builds of each structure")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--verify", options->race.verify,
                   "rays of each kind whose answers brute force verifies, every triangle for each")
        ->check(CLI::Range(0, 1 << 24))
        ->capture_default_str();
    app.add_option("--threads", options->race.threads, "for building and for tracing")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    app.add_option("--seed", options->race.seed, "of procedural meshes and of rays")
        ->capture_default_str();
    app.add_option("-o,--output", options->folder, "folder for rays.html, rays.json, rays.csv")
        ->capture_default_str();
    app.add_flag("--json", options->json, "print rays.json instead of the tables");
    app.footer("Ctrl-C keeps the meshes that were measured until then.\n"
               "Examples:\n"
               "  raylab bench-rays\n"
               "  raylab bench-rays bunny.glb dragon.glb --structures embree,embree_robust\n"
               "  raylab bench-rays sponza.glb --camera -100,20,-4,100,40,-4\n"
               "  raylab bench-rays --scaling terrain --triangles 100..4000000 --repeats 9");
    return [options] { return run_bench_rays(*options); };
}

} // namespace raylab::app
