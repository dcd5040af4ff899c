// What the wavefront costs on the CPU machine: lab 03 against lab 02, which keeps its paths in
// registers. There are no warps to be kept full here, so all that shows is the price of writing
// paths down. The two take turns; the median of the ratios counts. At most 1.6 is the aim.
#include "app/labs.h"
#include "common/load/load.h"
#include "common/render/render.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace raylab::app {

namespace {

double seconds_more(Renderer& renderer, int iterations) {
    const double before = renderer.ledger().seconds;
    add_samples(renderer, iterations);
    return renderer.ledger().seconds - before;
}

TEST(WavefrontSpeed, IsAtMostSixTenthsSlowerThanTheMegakernelOnTheCpuMachine) {
    const bool in_full = std::getenv("RAYLAB_LONG") != nullptr;
    for (const char* name : {"cornell", "cornell_peers", "microfacets"}) {
        const Scene scene = load_scene(find_scene(name));
        const auto megakernel = find_lab("02").make(scene, {});
        const auto wavefront = find_lab("03").make(scene, {});
        std::vector<double> ratios;
        for (int round = 0; round < (in_full ? 15 : 3); ++round) {
            const double two = seconds_more(*megakernel, in_full ? 8 : 2);
            ratios.push_back(seconds_more(*wavefront, in_full ? 8 : 2) / two);
        }
        std::sort(ratios.begin(), ratios.end());
        const double ratio = ratios[ratios.size() / 2];
        double compacting = 0;
        const Ledger ledger = wavefront->ledger();
        for (const StageCounts& stage : ledger.stages)
            if (stage.name == "compact") compacting = stage.seconds / ledger.seconds;
        fmt::print("{}: lab 03 / lab 02: median {:.3f} ({:.3f} to {:.3f}); compaction {:.1f} %\n",
                   name, ratio, ratios.front(), ratios.back(), 100 * compacting);
        // A machine that others share is too noisy for the figure.
        EXPECT_LT(ratio, in_full ? 1.6 : 5.0) << name;
    }
}

} // namespace

} // namespace raylab::app
