// The pool's permutation is one, for every length and seed.
#include "labs/03_wavefront/shuffle.h"

#include <gtest/gtest.h>

#include <vector>

namespace raylab::lab03 {

namespace {

TEST(Shuffle, IsAPermutationOfAnyLength) {
    for (const std::uint32_t n : {1u, 2u, 3u, 31u, 32u, 33u, 1000u, 4096u})
        for (const std::uint32_t seed : {0u, 1u, 0x80000000u, 77u}) {
            std::vector<int> seen(n, 0);
            for (std::uint32_t i = 0; i < n; ++i) ++seen.at(shuffled(i, n, seed));
            EXPECT_EQ(seen, std::vector<int>(n, 1)) << "n " << n << ", seed " << seed;
        }
}

TEST(Shuffle, MovesMostAndDependsOnTheSeed) {
    int stays = 0, same = 0;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        stays += shuffled(i, 1000, 5) == i;
        same += shuffled(i, 1000, 5) == shuffled(i, 1000, 6);
    }
    EXPECT_LT(stays, 20);
    EXPECT_LT(same, 20);
}

} // namespace

} // namespace raylab::lab03
