// The tree along the Morton curve, of tasks 4.4 to 4.6, as walks use it; and the given sort.
#include "common/sampling/hash.h"
#include "labs/04_accel/bvh/walk_stack.h"
#include "labs/04_accel/lbvh/radix_sort.h"
#include "labs/04_accel/leaf/query.h"
#include "labs/04_accel/tests/cases.h"
#include "labs/04_accel/tests/lbvh_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <set>

namespace raylab::lab04 {

namespace {

TEST(Lbvh, RaysFindWhatBruteForceFinds) {
    std::vector<Triangle> same;
    for (int i = 0; i < 3000; ++i) add(same, {0, 0, 0}, {1, 0, 1}, {0, 1, 0.5f});
    for (const auto& [what, triangles] : {std::pair{"soup", soup(1000, 0.3f)},
                                          {"hills", hills(24)},
                                          {"city", city(8)},
                                          {"same", same},
                                          {"five", soup(5, 1)},
                                          {"eight", soup(8, 1)},
                                          {"one", soup(1, 2)}}) {
        const BvhTree tree = build_from_codes(triangles);
        const Leaves leaves{{tree.packs.data(), int(tree.packs.size())},
                            {triangles.data(), int(triangles.size())}};
        const BvhView view{{tree.nodes.data(), int(tree.nodes.size())}};
        for (const Ray& ray : any_rays(triangles.size() > 2000 ? 300 : 2000)) {
            const Answer truth = brute_force(triangles, ray);
            ClosestHit closest(leaves, ray);
            walk_bvh_stack(view, closest);
            AnyHit any(leaves, ray);
            walk_bvh_stack(view, any);
            ASSERT_EQ(closest.hit().id, truth.id) << what;
            ASSERT_EQ(std::bit_cast<int>(closest.hit().t), std::bit_cast<int>(truth.t)) << what;
            ASSERT_EQ(any.found(), truth.any) << what;
        }
    }
}

TEST(Lbvh, TrianglesThatAreNoneAreLeftOut) {
    std::vector<Triangle> triangles = soup(100, 0.3f);
    add(triangles, Vec3(std::numeric_limits<float>::quiet_NaN()), {1, 0, 0}, {0, 1, 0});
    add(triangles, {0, infinity, 0}, {1, 0, 0}, {0, 1, 0});
    const BvhTree with = build_from_codes(triangles);
    std::set<int> indices;
    for (const TrianglePack& pack : with.packs)
        for (const int index : pack.index)
            if (index >= 0) indices.insert(index);
    EXPECT_EQ(indices.size(), 100u);
    EXPECT_EQ(*indices.rbegin(), 99);
}

TEST(RadixSort, IsStable) {
    for (const int n : {0, 1, 31, 1023, 1024, 1025, 20000}) {
        Dice dice(n + 1);
        std::vector<std::uint32_t> keys(n);
        for (std::uint32_t& key : keys)
            key = dice.below(3) == 0 ? dice.below(5) : dice.below(1 << 30);
        std::vector<int> order(n);
        std::iota(order.begin(), order.end(), 0);
        DeviceArray<std::uint32_t> device_keys(keys);
        DeviceArray<int> device_order(order);
        radix_sort(device_keys, device_order, 31);
        std::stable_sort(order.begin(), order.end(),
                         [&](int a, int b) { return keys[a] < keys[b]; });
        EXPECT_EQ(device_order.to_host(), order) << n;
        std::sort(keys.begin(), keys.end());
        EXPECT_EQ(device_keys.to_host(), keys) << n;
    }
}

} // namespace

} // namespace raylab::lab04
