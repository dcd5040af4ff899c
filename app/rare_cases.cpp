#include "app/rare_cases.h"

#include "common/cli/progress.h"
#include "common/load/load.h"
#include "common/math/index.h"
#include "common/render/render.h"

#include <algorithm>

namespace raylab::app {

using bench::RareCaseRow;
using bench::WavefrontCosts;

namespace {

struct RareCase {
    const char* name;
    const char* scene; // bundled
    WavefrontSettings wavefront;
    const char* why;
};

// The usual case first, to compare with.
std::vector<RareCase> rare_cases() {
    return {
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
         "one batch of blocks holds the pool, full or nearly empty: fewer blocks are not fewer "
         "batches"},
        {"pool always full",
         "cornell",
         {.pool = 16384, .regenerate = true},
         "ended paths make room for new ones at once: nothing to remove until the pixels run out"},
        {"one material",
         "cornell_peers",
         {.sort = MaterialSort::on},
         "sorting by material costs its passes and changes nothing"},
    };
}

// One of the three renderers that take turns, and its times.
struct Contestant {
    std::unique_ptr<Renderer> renderer;
    std::vector<double> seconds = {}; // for each round, the time of a sample
    double time(int iterations) {
        const double before = renderer->ledger().seconds;
        add_samples(*renderer, iterations);
        seconds.push_back((renderer->ledger().seconds - before) / iterations);
        return seconds.back();
    }
    // The median of all rounds but the first, which warms up.
    double median() const {
        std::vector<double> sorted(seconds.begin() + 1, seconds.end());
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }
};

// False in students' trees, which have one lab each.
bool has_megakernel() {
    return std::any_of(labs().begin(), labs().end(),
                       [](const Lab& lab) { return lab.number == "02"; });
}

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

RareCaseRow measure(const RareCase& shown, const MachineSettings& machine, int rounds) {
    const Scene scene = load_scene(find_scene(shown.scene));
    MachineSettings off = machine, on = machine;
    off.wavefront = on.wavefront = shown.wavefront;
    off.wavefront.compact_every = 0;
    off.wavefront.sort = MaterialSort::off;
    off.wavefront.regenerate = false;
    Contestant without{find_lab("03").make(scene, off)}, with{find_lab("03").make(scene, on)};
    std::optional<Contestant> megakernel;
    if (has_megakernel()) megakernel = {find_lab("02").make(scene, machine)};
    // One iteration warms up. After that a round has as many iterations as take some hundredths of
    // a second.
    if (megakernel) megakernel->time(1);
    with.time(1);
    const int iterations = std::max(1, index_of(0.05 / without.time(1), 65));
    for (int round = 0; round < rounds; ++round) {
        if (megakernel) megakernel->time(iterations);
        without.time(iterations);
        with.time(iterations);
    }
    return {shown.name,          shown.scene,
            shown.why,           scene.camera.width,
            scene.camera.height, megakernel ? std::optional(megakernel->median()) : std::nullopt,
            costs_of(without),   costs_of(with)};
}

} // namespace

std::vector<RareCaseRow> measure_rare_cases(const MachineSettings& machine, int rounds,
                                            const std::function<void(const RareCaseRow&)>& show) {
    const std::vector<RareCase> cases = rare_cases();
    Progress progress("rare cases", static_cast<int>(cases.size()), "cases", 1);
    std::vector<RareCaseRow> rows;
    for (const RareCase& rare : cases) {
        rows.push_back(measure(rare, machine, rounds));
        progress.clear();
        show(rows.back());
        progress.update(static_cast<int>(rows.size()));
    }
    return rows;
}

} // namespace raylab::app
