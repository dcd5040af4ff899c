#include "app/rare_cases.h"

#include "common/cli/progress.h"
#include "common/scene/load.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::app {

using nlohmann::ordered_json;

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
}

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
    // Of all but the first, which warms up.
    double median() const {
        std::vector<double> sorted(seconds.begin() + 1, seconds.end());
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }
};

// Students' trees have one lab each.
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

ordered_json to_json(const WavefrontCosts& costs) {
    return {{"seconds", costs.seconds},
            {"iterations", costs.iterations},
            {"launches", costs.launches},
            {"rays", costs.rays},
            {"blocks", costs.blocks},
            {"batches", costs.batches},
            {"share_of_compaction_and_sort", costs.removing},
            {"share_between_launches", costs.between}};
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
    // One to warm up, then enough a round that it takes some hundredths of a second.
    if (megakernel) megakernel->time(1);
    with.time(1);
    const int iterations = std::clamp(static_cast<int>(0.05 / without.time(1)), 1, 64);
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

ordered_json to_json(const RareCaseRow& row) {
    const ordered_json megakernel =
        row.megakernel ? ordered_json{{"seconds", *row.megakernel}} : ordered_json(nullptr);
    return {{"case", row.name},
            {"scene", row.scene},
            {"why", row.why},
            {"width", row.width},
            {"height", row.height},
            {"megakernel", megakernel},
            {"without", to_json(row.without)},
            {"with", to_json(row.with)}};
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

std::string rare_case_header() {
    return fmt::format("Per sample of the whole image; live rays: mean of an iteration's; between: "
                       "share of the time between launches.\n"
                       "  {:20} {:>9} {:>7} {:>6} {:>9} {:>8} {:>8} {:>8} {:>9} {:>9}\n",
                       "", "ms", "to 02", "iter.", "live rays", "blocks", "batches", "launches",
                       "removing", "between");
}

std::string to_table(const RareCaseRow& row) {
    const auto ratio = [&](double seconds) {
        return row.megakernel ? fmt::format("{:.2f}", seconds / *row.megakernel) : "-";
    };
    const auto line = [&](const char* name, const WavefrontCosts& c) {
        return fmt::format("  {:20} {:9.3f} {:>7} {:6.0f} {:9.0f} {:8.0f} {:8.0f} {:8.0f} "
                           "{:7.1f} % {:7.1f} %\n",
                           name, 1e3 * c.seconds, ratio(c.seconds), c.iterations,
                           c.rays / c.iterations, c.blocks, c.batches, c.launches, 100 * c.removing,
                           100 * c.between);
    };
    std::string text =
        fmt::format("{}: {}, {} x {}. {}\n", row.name, row.scene, row.width, row.height, row.why);
    if (row.megakernel)
        text += fmt::format("  {:20} {:9.3f} {:>7}\n", "megakernel", 1e3 * *row.megakernel,
                            ratio(*row.megakernel));
    return text + line("without compaction", row.without) + line("with it", row.with);
}

ordered_json to_json(const std::vector<RareCaseRow>& rows) {
    ordered_json json = ordered_json::array();
    for (const RareCaseRow& row : rows) json.push_back(to_json(row));
    return json;
}

} // namespace raylab::app
