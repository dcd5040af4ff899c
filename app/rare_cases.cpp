#include "app/rare_cases.h"

#include "common/scene/load.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::app {

const std::vector<RareCase>& rare_cases() {
    static const std::vector<RareCase> cases = {
        {"it gains", "cornell", {}, "rays end in every bounce: the usual case"},
        {"no ray ends",
         "no_ray_ends",
         {},
         "a closed furnace: the list is as long in the last bounce as in the first"},
        {"tiny image",
         "tiny_image",
         {},
         "all rays fit into one batch from the start; what is left to save is less than a launch"},
        {"all end at once",
         "all_end_at_once",
         {},
         "every path ends with its second ray: nothing to remove before there is nothing left"},
        {"small pool",
         "cornell",
         {.pool = 256},
         "one batch holds the pool, full or nearly empty: fewer blocks are not fewer batches"},
        {"pool always full",
         "cornell",
         {.pool = 16384, .regenerate = true},
         "ended paths make room for new ones at once: nothing to remove until the pixels run out"},
        {"one material",
         "cornell_peers",
         {.sort = MaterialSort::on},
         "sorting by material costs its passes and changes nothing"},
    };
    return cases;
}

namespace {

// One of the three that take turns, and its times.
struct Contestant {
    std::unique_ptr<Renderer> renderer;
    std::vector<double> seconds = {}; // a sample, of each round
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

WavefrontCosts costs_of(const Contestant& contestant) {
    const Ledger ledger = contestant.renderer->ledger();
    const double samples = ledger.samples;
    WavefrontCosts costs;
    costs.seconds = contestant.median();
    double in_stages = 0;
    for (const StageCounts& stage : ledger.stages) {
        costs.launches += stage.launches / samples;
        in_stages += stage.seconds;
        if (stage.name == "intersect") {
            costs.iterations = stage.launches / samples;
            costs.blocks = stage.blocks / samples;
        }
        if (stage.name == "compact" || stage.name == "sort")
            costs.removing += stage.seconds / ledger.seconds;
    }
    for (const BounceCounts& bounce : ledger.bounces) {
        costs.rays += bounce.rays / samples;
        costs.batches += bounce.batches / samples;
    }
    costs.between = std::max(0.0, 1 - in_stages / ledger.seconds);
    return costs;
}

nlohmann::ordered_json to_json(const WavefrontCosts& costs) {
    return {{"seconds", costs.seconds},
            {"iterations", costs.iterations},
            {"launches", costs.launches},
            {"rays", costs.rays},
            {"blocks", costs.blocks},
            {"batches", costs.batches},
            {"share_of_compaction_and_sort", costs.removing},
            {"share_between_launches", costs.between}};
}

} // namespace

RareCaseRow measure(const RareCase& shown, const MachineSettings& machine, int rounds) {
    const Scene scene = load_scene(find_scene(shown.scene));
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
            scene.camera.width,
            scene.camera.height,
            megakernel.median(),
            costs_of(without),
            costs_of(with)};
}

std::string rare_case_header() {
    return fmt::format("Per sample of the whole image; live rays: mean of an iteration's; between: "
                       "share of the time between launches.\n"
                       "  {:20} {:>9} {:>7} {:>6} {:>9} {:>8} {:>8} {:>8} {:>9} {:>9}\n",
                       "", "ms", "to 02", "iter.", "live rays", "blocks", "batches", "launches",
                       "removing", "between");
}

std::string to_table(const RareCaseRow& row) {
    const auto line = [&](const char* name, const WavefrontCosts& c) {
        return fmt::format("  {:20} {:9.3f} {:7.2f} {:6.0f} {:9.0f} {:8.0f} {:8.0f} {:8.0f} "
                           "{:7.1f} % {:7.1f} %\n",
                           name, 1e3 * c.seconds, c.seconds / row.megakernel, c.iterations,
                           c.rays / c.iterations, c.blocks, c.batches, c.launches, 100 * c.removing,
                           100 * c.between);
    };
    return fmt::format("{}: {}, {} x {}. {}\n  {:20} {:9.3f} {:7.2f}\n", row.shown->name,
                       row.shown->scene, row.width, row.height, row.shown->why, "megakernel",
                       1e3 * row.megakernel, 1.0) +
           line("without compaction", row.without) + line("with it", row.with);
}

nlohmann::ordered_json to_json(const RareCaseRow& row) {
    return {{"case", row.shown->name},
            {"scene", row.shown->scene},
            {"why", row.shown->why},
            {"width", row.width},
            {"height", row.height},
            {"megakernel", {{"seconds", row.megakernel}}},
            {"without", to_json(row.without)},
            {"with", to_json(row.with)}};
}

} // namespace raylab::app
