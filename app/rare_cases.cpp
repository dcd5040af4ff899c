// raylab rare-cases: "there are a few rare edge cases where this approach does not provide a
// performance boost. Can you think of any?" Each case, measured: the megakernel, the wavefront
// without compaction, and with it.
#include "app/commands.h"
#include "common/cli/progress.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace raylab::app {

namespace {

struct Case {
    const char* name;
    const char* scene;
    SceneChanges changes;
    WavefrontSettings wavefront;
    const char* why;
};

SceneChanges film(int width, int height) {
    SceneChanges changes;
    changes.width = width;
    changes.height = height;
    return changes;
}

std::vector<Case> cases() {
    return {
        {"it gains", "cornell", film(256, 256), {}, "rays end in every bounce: the usual case"},
        {"no ray ends",
         "white_furnace",
         film(128, 128),
         {},
         "a closed furnace: the list is as long in the last bounce as in the first"},
        {"tiny image",
         "cornell",
         film(16, 16),
         {},
         "all rays fit into one batch from the start; what is left to save is less than a launch"},
        {"all end at once",
         "polygon_light",
         film(256, 256),
         {},
         "every path ends with its second surface: nothing to remove before there is nothing left"},
        {"small pool",
         "cornell",
         film(256, 256),
         {.pool = 256},
         "one batch holds the pool, full or nearly empty: fewer blocks are not fewer batches"},
        {"pool always full",
         "cornell",
         film(256, 256),
         {.pool = 16384, .regenerate = true},
         "ended paths make room for new ones at once: nothing to remove until the pixels run out"},
        {"one material",
         "cornell_peers",
         film(256, 256),
         {.sort = MaterialSort::on},
         "sorting by material costs its passes and changes nothing"},
    };
}

// One of the three that take turns, and its times.
struct Contestant {
    std::unique_ptr<Renderer> renderer;
    std::vector<double> seconds = {}; // of each round
    double time(int iterations) {
        const double before = renderer->ledger().seconds;
        for (int i = 0; i < iterations; ++i) renderer->add_iteration();
        seconds.push_back((renderer->ledger().seconds - before) / iterations);
        return seconds.back();
    }
    double median() const {
        std::vector<double> sorted = seconds;
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }
};

// What the table says of one wavefront.
struct Counts {
    std::uint64_t launches = 0, iterations = 0, blocks = 0, batches = 0, rays = 0;
    double between = 0, removing = 0; // shares of the time
};

Counts counts_of(const Ledger& ledger) {
    Counts counts;
    double in_stages = 0;
    for (const StageCounts& stage : ledger.stages) {
        counts.launches += stage.launches;
        in_stages += stage.seconds;
        if (stage.name == "intersect") {
            counts.iterations = stage.launches;
            counts.blocks = stage.blocks;
        }
        if (stage.name == "compact" || stage.name == "sort")
            counts.removing += stage.seconds / ledger.seconds;
    }
    for (const BounceCounts& bounce : ledger.bounces) {
        counts.rays += bounce.rays;
        counts.batches += bounce.batches;
    }
    counts.between = std::max(0.0, 1 - in_stages / ledger.seconds);
    return counts;
}

struct Row {
    const Case* shown;
    double megakernel, without, with; // seconds a sample
    Counts counts_without, counts_with;
    int samples;
};

Row measure(const Case& shown, const MachineSettings& machine, int rounds) {
    const Scene scene = load_changed_scene(shown.scene, shown.changes);
    MachineSettings off = machine, on = machine;
    off.wavefront = on.wavefront = shown.wavefront;
    off.wavefront.compact_every = 0;
    off.wavefront.sort = MaterialSort::off;
    off.wavefront.regenerate = false;
    Contestant megakernel{find_lab("02").make(scene, machine)};
    Contestant without{find_lab("03").make(scene, off)}, with{find_lab("03").make(scene, on)};
    // Enough iterations a round that it takes some hundredths of a second.
    const int iterations = std::clamp(static_cast<int>(0.05 / megakernel.time(1)), 1, 64);
    megakernel.seconds.clear();
    for (int round = 0; round < rounds; ++round) {
        megakernel.time(iterations);
        without.time(iterations);
        with.time(iterations);
    }
    return {&shown,
            megakernel.median(),
            without.median(),
            with.median(),
            counts_of(without.renderer->ledger()),
            counts_of(with.renderer->ledger()),
            with.renderer->ledger().samples};
}

nlohmann::ordered_json to_json(const Row& row) {
    const auto wavefront = [&](double seconds, const Counts& counts) {
        const double n = row.samples;
        return nlohmann::ordered_json{{"seconds", seconds},
                                      {"iterations", counts.iterations / n},
                                      {"launches", counts.launches / n},
                                      {"rays", counts.rays / n},
                                      {"blocks", counts.blocks / n},
                                      {"batches", counts.batches / n},
                                      {"share_of_compaction_and_sort", counts.removing},
                                      {"share_between_launches", counts.between}};
    };
    return {{"case", row.shown->name},
            {"scene", row.shown->scene},
            {"why", row.shown->why},
            {"megakernel", {{"seconds", row.megakernel}}},
            {"without", wavefront(row.without, row.counts_without)},
            {"with", wavefront(row.with, row.counts_with)}};
}

void print(const Row& row) {
    const auto line = [&](const char* name, double seconds, const Counts& c) {
        const double n = row.samples;
        fmt::print("  {:20} {:9.3f} {:7.2f} {:6.0f} {:9.0f} {:8.0f} {:8.0f} {:8.0f} {:7.1f} % "
                   "{:7.1f} %\n",
                   name, 1e3 * seconds, seconds / row.megakernel, c.iterations / n,
                   static_cast<double>(c.rays) / static_cast<double>(c.iterations), c.blocks / n,
                   c.batches / n, c.launches / n, 100 * c.removing, 100 * c.between);
    };
    fmt::print("{}: {}. {}\n", row.shown->name, row.shown->scene, row.shown->why);
    fmt::print("  {:20} {:9.3f} {:7.2f}\n", "megakernel", 1e3 * row.megakernel, 1.0);
    line("without compaction", row.without, row.counts_without);
    line("with it", row.with, row.counts_with);
}

struct RareCaseOptions {
    MachineSettings machine;
    int rounds = 5;
    bool json = false;
};

ExitCode run_rare_cases(const RareCaseOptions& options) {
    const std::vector<Case> all = cases();
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    if (!options.json)
        fmt::print("Per sample of the whole image; live rays: mean of an iteration's.\n"
                   "  {:20} {:>9} {:>7} {:>6} {:>9} {:>8} {:>8} {:>8} {:>9} {:>9}\n",
                   "", "ms", "to 02", "iter.", "live rays", "blocks", "batches", "launches",
                   "removing", "between");
    Progress progress("rare cases", static_cast<int>(all.size()), "cases", 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Row row = measure(all[i], options.machine, options.rounds);
        progress.clear();
        if (options.json)
            json.push_back(to_json(row));
        else
            print(row);
        progress.update(static_cast<int>(i) + 1);
    }
    if (options.json) fmt::print("{}\n", json.dump(2));
    return ExitCode::success;
}

} // namespace

Run add_rare_cases(CLI::App& app) {
    auto options = std::make_shared<RareCaseOptions>();
    app.description("Where compaction gains nothing: labs 02 and 03 on the rare cases, measured.");
    app.add_option("--repeats", options->rounds, "rounds; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_flag("--json", options->json, "print JSON instead of the table");
    add_machine_options(app, options->machine);
    app.footer("Examples:\n  raylab rare-cases\n  raylab rare-cases --repeats 15 --json");
    return [options] { return run_rare_cases(*options); };
}

} // namespace raylab::app
