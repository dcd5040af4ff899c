// Task 3.3: compaction keeps what is alive, all of it, once, in order; a split by one bit does the
// same with both groups. Unit tests on lists; the renderer's image is the pool's test.
#include "common/device/device_array.h"
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/03_wavefront/compact.h"
#include "labs/03_wavefront/renderer.h"
#include "labs/03_wavefront/shuffle.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace raylab::lab03 {

namespace {

using namespace task;

constexpr int no_slot = -99;      // of an array,
constexpr int places_behind = 64; // and so many places behind its end

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

// What compaction leaves in the list. Fails the test if it writes behind the list's end.
std::vector<int> kept(ScanKind scan, const std::vector<std::uint8_t>& alive,
                      const std::vector<int>& list) {
    const int n = static_cast<int>(list.size());
    const int room = n + places_behind;
    Compaction compaction(scan, room, 64);
    {
        // A longer list before this one, of which all is kept, leaves its flags behind.
        std::vector<int> all(room);
        std::iota(all.begin(), all.end(), 0);
        const DeviceArray<std::uint8_t> all_alive(std::vector<std::uint8_t>(room, 1));
        const DeviceArray<int> longer(all);
        DeviceArray<int> rest(room);
        compaction.keep_alive(all_alive.data(), longer.data(), room, rest.data());
    }
    const DeviceArray<std::uint8_t> device_alive(alive);
    std::vector<int> with_room = list;
    with_room.resize(room, 0);
    const DeviceArray<int> live(with_room);
    DeviceArray<int> result(std::vector<int>(n + places_behind, no_slot));
    const int count = compaction.keep_alive(device_alive.data(), live.data(), n, result.data());
    std::vector<int> host = result.to_host();
    expect(std::count(host.begin() + n, host.end(), no_slot) == places_behind,
           fmt::format("a list of {} slots is written behind its end; the likely cause: threads "
                       "from n on must do nothing",
                       n));
    host.resize(std::clamp(count, 0, n));
    return host;
}

// What differs between two lists, and its likely cause.
std::string unlike(const std::vector<int>& got, const std::vector<int>& expected,
                   const std::vector<int>& list, const std::vector<std::uint8_t>& alive) {
    const auto [at, right] = std::mismatch(got.begin(), got.end(), expected.begin());
    const auto place = at - got.begin();
    std::vector<int> sorted = got, all = expected, places;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (alive[list[i]]) places.push_back(static_cast<int>(i));
    std::sort(sorted.begin(), sorted.end());
    std::sort(all.begin(), all.end());
    const bool known = std::find(list.begin(), list.end(), *at) != list.end();
    const char* cause =
        got == places ? "it is the slot live[i] that is kept, not its place i in the list"
        : sorted == all
            ? "the right slots are kept, but in another order: compaction is stable, and "
              "a slot's place is the number of those kept before it"
        : !known ? "the place is not written at all: every slot that is flagged must be "
                   "scattered, by as many blocks as the list needs"
        : !alive[*at]
            ? "a slot that has ended is kept: only threads where flags[i] is set may write"
            : "a kept slot, live[i], goes to the place that the scan of the flags gives it";
    return fmt::format("of {} slots place {} of the new list should have slot {} but has {}; the "
                       "likely cause: {}",
                       list.size(), place, *right, *at, cause);
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
                              "the count is the sum of the flags, which scan_flags() returns") ||
                (result != expected && !expect(false, unlike(result, expected, list, alive))))
                return;
        }
    }
}

TEST(Task3_3, NoneAllAndOneAlive) {
    const std::vector<int> list = slots(100);
    expect(kept(ScanKind::library, std::vector<std::uint8_t>(100, 0), list).empty(),
           "of 100 slots of which none is alive some are kept");
    expect(kept(ScanKind::library, std::vector<std::uint8_t>(100, 1), list) == list,
           "of 100 slots that are all alive the list is not what it was");
    std::vector<std::uint8_t> one(100, 0);
    one[42] = 1;
    expect(kept(ScanKind::library, one, list) == std::vector<int>{42},
           "where slot 42 alone is alive, the list is not that slot");
}

TEST(Task3_3, ThreeSplitsSortStably) {
    for (const int n : {1, 33, 5000}) {
        const std::vector<std::uint8_t> key = keys(n, 8);
        std::vector<int> expected = slots(n);
        const DeviceArray<std::uint8_t> device_key(key);
        DeviceArray<int> list(expected), spare(n);
        Compaction compaction(ScanKind::library, n, 64);
        // By one bit, and what the likely cause is if it is not.
        const std::vector<int> before = expected;
        compaction.split_by_bit(device_key.data(), 0, list.data(), n, spare.data());
        const std::vector<int> split = spare.to_host();
        const auto has_bit = [&](int slot) { return (key[slot] & 1) != 0; };
        std::stable_partition(expected.begin(), expected.end(), std::not_fn(has_bit));
        const auto first = std::count_if(before.begin(), before.end(), std::not_fn(has_bit));
        if (!expect(std::is_permutation(split.begin(), split.end(), expected.begin()),
                    fmt::format("a split of {} slots by a bit loses some and has others twice; the "
                                "likely cause: the second group begins behind all of the first, at "
                                "the sum of the flags, and has its own places 0, 1, 2, ...",
                                n)) ||
            !expect(
                std::is_partitioned(split.begin(), split.end(), std::not_fn(has_bit)),
                fmt::format("a split of {} slots by a bit should begin with the {} whose bit is "
                            "clear; the likely cause: the first group is not put first",
                            n, first)) ||
            !expect(split == expected,
                    fmt::format("a split of {} slots by a bit should keep the order within both "
                                "groups, but does not; the likely cause: a slot's place in its "
                                "group is the number of those of its group before it",
                                n)))
            return;
        expected = before;
        std::stable_sort(expected.begin(), expected.end(),
                         [&](int a, int b) { return key[a] < key[b]; });
        for (int bit = 0; bit < 3; ++bit) {
            compaction.split_by_bit(device_key.data(), bit, list.data(), n, spare.data());
            std::swap(list, spare);
        }
        expect(list.to_host() == expected,
               fmt::format("{} slots are not sorted by kind, each kind in its order, by three "
                           "splits; the likely cause: split_by_bit() must flag by its `bit`",
                           n));
    }
}

// How the list is run changes no bit of the image: compacted, sorted, or left as it is.
TEST(Task3_3, TheImageStaysTheSame) {
    const Scene scene = small_scene(
        {.materials = R"("wall": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
            "mirror": {"kind": "mirror", "reflectance": [0.9, 0.9, 0.9]})",
         .shapes =
             R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "material": "wall"},
                {"kind": "sphere", "center": [1, 0, 1], "radius": 1, "material": "mirror"},
                {"kind": "plane", "point": [3, 0, 0], "normal": [1, 0, 0], "material": "wall"})",
         .lights = R"({"kind": "environment", "radiance": [1, 1, 1]})",
         .render = R"("max_depth": 6, "spp": 1)"});
    const auto film = [&](int compact_every, MaterialSort sort) {
        const auto renderer =
            make_renderer(scene, {.threads = 1,
                                  .block_size = 64,
                                  .wavefront = {.compact_every = compact_every, .sort = sort}});
        for (int i = 0; i < 2; ++i) renderer->add_iteration();
        return renderer->film();
    };
    const Film plain = film(0, MaterialSort::off);
    expect(same_bits(film(1, MaterialSort::off), plain),
           "with compaction the image is another; the likely cause: paths are lost from the list, "
           "or stand in it twice") &&
        expect(same_bits(film(0, MaterialSort::on), plain),
               "with --sort on the image is another; the likely cause: paths are lost from the "
               "list, or stand in it twice");
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
