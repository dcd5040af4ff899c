// The wavefront's choices together: whichever are made, the image has lab 02's bits. All
// combinations are thousands and take minutes (RAYLAB_LONG=1). The quick test takes a subset in
// which any two levels of any two choices meet: mistakes that need three at once are rare. Kuhn,
// Wallace and Gallo, Software Fault Interactions and Implications for Software Testing, 2004.
#include "app/tests/agreement.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

namespace raylab::app {

namespace {

// The levels of each choice.
constexpr std::array scans = {ScanKind::serial, ScanKind::naive,   ScanKind::efficient,
                              ScanKind::warp,   ScanKind::library, ScanKind::lookback};
constexpr std::array compactions = {0, 1, 3};
constexpr std::array sorts = {MaterialSort::off, MaterialSort::on, MaterialSort::queues};
constexpr std::array pools = {1, 1021, 4096, 1 << 20};
constexpr std::array blocks = {32, 96, 256, 1000, 1024};
constexpr std::array shuffles = {0u, 9u};
constexpr std::array regenerates = {false, true};

constexpr std::array<std::size_t, 7> levels = {
    scans.size(),  compactions.size(), sorts.size(),      pools.size(),
    blocks.size(), shuffles.size(),    regenerates.size()};
using Combination = std::array<std::size_t, levels.size()>; // a level of each

// turn: number of the combination; it also chooses the number of threads and their order.
MachineSettings settings_of(const Combination& c, std::size_t turn) {
    return {.threads = 1 + static_cast<int>(turn % 2),
            .block_size = blocks[c[4]],
            .order = static_cast<ThreadOrder>(turn % 3),
            .wavefront = {.compact_every = compactions[c[1]],
                          .scan = scans[c[0]],
                          .sort = sorts[c[2]],
                          .pool = pools[c[3]],
                          .shuffle = shuffles[c[5]],
                          .regenerate = regenerates[c[6]]}};
}

std::string described(const MachineSettings& machine) {
    const WavefrontSettings& w = machine.wavefront;
    return fmt::format("compaction {}, scan {}, sort {}, pool {}, block {}, shuffle {}, "
                       "regenerate {}, {} threads, order {}",
                       w.compact_every, static_cast<int>(w.scan), static_cast<int>(w.sort), w.pool,
                       machine.block_size, w.shuffle, w.regenerate, machine.threads,
                       static_cast<int>(machine.order));
}

std::vector<Combination> all_combinations() {
    std::vector<Combination> all = {{}};
    for (std::size_t choice = 0; choice < levels.size(); ++choice) {
        std::vector<Combination> longer;
        for (Combination combination : all)
            for (combination[choice] = 0; combination[choice] < levels[choice];
                 ++combination[choice])
                longer.push_back(combination);
        all = longer;
    }
    return all;
}

// Level a of choice i beside level b of choice j.
using Pair = std::array<std::size_t, 4>;

std::vector<Pair> pairs_in(const Combination& c) {
    std::vector<Pair> pairs;
    for (std::size_t j = 1; j < c.size(); ++j)
        for (std::size_t i = 0; i < j; ++i) pairs.push_back({i, c[i], j, c[j]});
    return pairs;
}

// Greedy: each step takes the combination with the most pairs that no earlier combination has.
std::vector<Combination> pairwise_combinations() {
    const std::vector<Combination> all = all_combinations();
    std::set<Pair> left;
    for (const Combination& c : all)
        for (const Pair& pair : pairs_in(c)) left.insert(pair);
    std::vector<Combination> chosen;
    while (!left.empty()) {
        const auto gain = [&](const Combination& c) {
            const std::vector<Pair> pairs = pairs_in(c);
            return std::count_if(pairs.begin(), pairs.end(),
                                 [&](const Pair& pair) { return left.contains(pair); });
        };
        std::vector<std::ptrdiff_t> gains;
        for (const Combination& c : all) gains.push_back(gain(c));
        chosen.push_back(all[std::max_element(gains.begin(), gains.end()) - gains.begin()]);
        for (const Pair& pair : pairs_in(chosen.back())) left.erase(pair);
    }
    return chosen;
}

class Combinations : public testing::TestWithParam<const char*> {};

TEST_P(Combinations, OfAllChoicesHaveTheBitsOfTheIterativeLab) {
    const std::vector<Combination> chosen =
        std::getenv("RAYLAB_LONG") ? all_combinations() : pairwise_combinations();
    // More pixels than the larger pool; but with a pool of one path every pixel is a fill.
    const Scene usual = small(GetParam(), 80, 7), tiny = small(GetParam(), 9, 7);
    ASSERT_GT(usual.camera.width * usual.camera.height, 4096);
    const Traced usual_truth = trace("02", usual, {}, 1), tiny_truth = trace("02", tiny, {}, 1);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const MachineSettings machine = settings_of(chosen[i], i);
        const bool alone = machine.wavefront.pool == 1;
        const Scene& scene = alone ? tiny : usual;
        const Traced& truth = alone ? tiny_truth : usual_truth;
        const Traced traced = trace("03", scene, machine, 1);
        ASSERT_EQ(first_difference(traced, truth, scene.camera.width), "") << described(machine);
        ASSERT_TRUE(same_bits(traced.film, truth.film)) << described(machine);
    }
    RecordProperty("combinations", static_cast<int>(chosen.size()));
}

// Three materials to sort; and trees, whose branches wait in the pool.
INSTANTIATE_TEST_SUITE_P(Bundled, Combinations, testing::Values("cornell_spheres", "whitted"),
                         [](const auto& info) { return std::string(info.param); });

TEST(PairwiseCombinations, AreFewAndLeaveNoPairOut) {
    std::set<Pair> all, met;
    for (const Combination& c : all_combinations())
        for (const Pair& pair : pairs_in(c)) all.insert(pair);
    const std::vector<Combination> chosen = pairwise_combinations();
    for (const Combination& c : chosen)
        for (const Pair& pair : pairs_in(c)) met.insert(pair);
    EXPECT_EQ(met, all);
    EXPECT_EQ(all_combinations().size(), 4320u);
    EXPECT_LE(chosen.size(), 45u) << "thirty at least: six scans times five block sizes";
}

} // namespace

} // namespace raylab::app
