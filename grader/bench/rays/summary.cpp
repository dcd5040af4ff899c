#include "grader/bench/rays/rays_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab::bench {

namespace {

const RayRow* find_row(const RayRace& race, const std::string& name) {
    const auto row = std::find_if(race.rows.begin(), race.rows.end(),
                                  [&](const RayRow& r) { return r.name == name; });
    return row == race.rows.end() || !row->failure.empty() ? nullptr : &*row;
}

RaySummary summary(const RaysBench& bench, const std::string& name) {
    RaySummary result;
    result.name = name;
    std::vector<double> logs(std::size_t(bench.options.rounds), 0), medians;
    int cells = 0;
    for (const RayRace& race : bench.races) {
        // A kind without rays has no cell: nothing was hit that they could start from.
        cells += int(std::count_if(race.ray_counts.begin(), race.ray_counts.end(),
                                   [](int count) { return count > 0; }));
        const RayRow* row = find_row(race, name);
        if (!row) continue;
        for (const RayCell& cell : row->cells) {
            if (!cell.ratio || !cell.ratio->is_known()) continue;
            medians.push_back(cell.ratio->median);
            for (std::size_t r = 0; r < logs.size(); ++r)
                logs[r] += std::log(cell.ratio->rounds[r]);
        }
    }
    if (int(medians.size()) < cells || cells == 0) {
        result.why_not = fmt::format("{} of {} ratios", medians.size(), cells);
        return result;
    }
    for (double& log : logs) log = std::exp(log / cells);
    result.mean = measured(logs);
    const auto [worst, best] = std::minmax_element(medians.begin(), medians.end());
    result.worst = *worst;
    result.best = *best;
    return result;
}

} // namespace

std::vector<RaySummary> summaries(const RaysBench& bench) {
    std::vector<RaySummary> result;
    if (!bench.races.empty())
        for (const RayRow& row : bench.races.front().rows)
            result.push_back(summary(bench, row.name));
    return result;
}

} // namespace raylab::bench
