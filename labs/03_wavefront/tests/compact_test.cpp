// Task 3.3: compaction keeps what is alive, all of it, once, in order; a split by one bit does the
// same with both groups. Unit tests on lists; the renderer's image is the pool's test.
#include "common/device/device_array.h"
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/03_wavefront/compact.h"
#include "labs/03_wavefront/renderer.h"
#include "labs/03_wavefront/shuffle.h"

#include <algorithm>
#include <numeric>

namespace raylab::lab03 {

namespace {

using namespace task;

// Every slot once, in disorder, and a key or flag for each.
std::vector<int> slots(int n) {
    std::vector<int> list(n);
    for (int i = 0; i < n; ++i) list[i] = static_cast<int>(shuffled(i, n, 99));
    return list;
}
std::vector<std::uint8_t> keys(int n, int below) {
    std::vector<std::uint8_t> key(n);
    for (int i = 0; i < n; ++i) key[i] = (i * 2654435761u >> 16) % below;
    return key;
}

std::vector<int> kept(ScanKind scan, const std::vector<std::uint8_t>& alive,
                      const std::vector<int>& list) {
    const int n = static_cast<int>(list.size());
    Compaction compaction(scan, std::max(n, 1), 64);
    const DeviceArray<std::uint8_t> device_alive(alive);
    const DeviceArray<int> live(list);
    DeviceArray<int> result(n);
    const int count = compaction.keep_alive(device_alive.data(), live.data(), n, result.data());
    std::vector<int> host = result.to_host();
    host.resize(count);
    return host;
}

TEST(Task3_3, CompactionKeepsTheLivingInOrder) {
    for (const int n : {0, 1, 2, 31, 33, 1000, 4097}) {
        const std::vector<std::uint8_t> alive = keys(n, 2);
        const std::vector<int> list = slots(n);
        std::vector<int> expected;
        std::copy_if(list.begin(), list.end(), std::back_inserter(expected),
                     [&](int slot) { return alive[slot] != 0; });
        for (const ScanKind scan : {ScanKind::serial, ScanKind::library}) {
            const std::vector<int> result = kept(scan, alive, list);
            if (!expect_equal(fmt::format("slots kept of {}", n),
                              static_cast<long long>(result.size()),
                              static_cast<long long>(expected.size()),
                              "the count is the last flag plus the last place") ||
                !expect(result == expected,
                        fmt::format("of {} slots the wrong ones are kept, or in another order; the "
                                    "likely cause: kept[places[i]] = live[i], where flags[i]",
                                    n)))
                return;
        }
    }
}

TEST(Task3_3, NoneAllAndOneAlive) {
    const std::vector<int> list = slots(100);
    EXPECT_TRUE(kept(ScanKind::library, std::vector<std::uint8_t>(100, 0), list).empty());
    EXPECT_EQ(kept(ScanKind::library, std::vector<std::uint8_t>(100, 1), list), list);
    std::vector<std::uint8_t> one(100, 0);
    one[42] = 1;
    EXPECT_EQ(kept(ScanKind::library, one, list), std::vector<int>{42});
}

TEST(Task3_3, ThreeSplitsSortStably) {
    for (const int n : {1, 33, 5000}) {
        const std::vector<std::uint8_t> key = keys(n, 8);
        std::vector<int> expected = slots(n);
        const DeviceArray<std::uint8_t> device_key(key);
        DeviceArray<int> list(expected), spare(n);
        std::stable_sort(expected.begin(), expected.end(),
                         [&](int a, int b) { return key[a] < key[b]; });
        Compaction compaction(ScanKind::library, n, 64);
        for (int bit = 0; bit < 3; ++bit) {
            compaction.split_by_bit(device_key.data(), bit, list.data(), n, spare.data());
            std::swap(list, spare);
        }
        expect(list.to_host() == expected,
               fmt::format("{} slots are not sorted by kind, each kind in its order; the likely "
                           "cause: the second group begins behind all of the first, at the sum of "
                           "the flags",
                           n));
    }
}

// Each bounce fewer threads: what compaction is for.
TEST(Task3_3, LaunchesShrinkWithTheRays) {
    const Scene scene = small_scene(
        {.materials = R"("wall": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})",
         .shapes =
             R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "material": "wall"},
                {"kind": "plane", "point": [3, 0, 0], "normal": [1, 0, 0], "material": "wall"})",
         .lights = R"({"kind": "environment", "radiance": [1, 1, 1]})",
         .render = R"("max_depth": 8, "spp": 1)",
         .width = 64,
         .height = 64});
    const auto threads = [&](int compact_every) {
        const auto renderer =
            make_renderer(scene, {.threads = 1, .wavefront = {.compact_every = compact_every}});
        renderer->add_iteration();
        for (const StageCounts& stage : renderer->ledger().stages)
            if (stage.name == "intersect") return stage.threads;
        return std::uint64_t{0};
    };
    expect(
        threads(1) < threads(0) / 2,
        fmt::format("the intersect stage launches {} threads with compaction and {} without; the "
                    "likely cause: compaction returns the list as it was",
                    threads(1), threads(0)));
}

} // namespace

} // namespace raylab::lab03
