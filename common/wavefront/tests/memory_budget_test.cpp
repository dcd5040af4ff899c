// The pool and the memory: a pool that shrinks, a refusal that says why.
#include "common/wavefront/memory_budget.h"

#include <gtest/gtest.h>

namespace raylab {

namespace {

TEST(Memory, ThePoolShrinksToWhatIsLeft) {
    const MemoryNeeds needs = {.scene_bytes = 1000, .film_bytes = 7000, .slot_bytes = 200};
    EXPECT_EQ(pool_that_fits(1 << 30, needs, 5000), 5000);
    EXPECT_EQ(pool_that_fits(8000 + 200 * 100, needs, 5000), 100);
    EXPECT_EQ(pool_that_fits(8000 + 200 * 101 - 1, needs, 5000), 100);
    EXPECT_EQ(pool_that_fits(8000 + 200, needs, 1), 1) << "an image of one pixel needs one path";
    // The lecture's 1.5 GB.
    EXPECT_EQ(pool_that_fits(1610612736, needs, 1 << 28), (1610612736 - 8000) / 200);
}

void expect_refusal(std::int64_t budget, const MemoryNeeds& needs,
                    const std::vector<std::string>& words) {
    try {
        pool_that_fits(budget, needs, 5000);
        FAIL() << "a budget of " << budget << " bytes is too small";
    } catch (const SettingsError& error) {
        for (const std::string& word : words)
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
}

TEST(Memory, WhatCannotFitIsRefusedWithTheFigures) {
    const MemoryNeeds needs = {.scene_bytes = 3 << 20, .film_bytes = 7 << 20, .slot_bytes = 200};
    for (const std::int64_t budget : {std::int64_t{1}, std::int64_t{10} << 20})
        expect_refusal(budget, needs,
                       {"scene takes 3.00 MiB, the film 7.00 MiB", "200 bytes", "32 paths",
                        "--memory-budget or a smaller image."});
}

TEST(Memory, AStructureCountsAndIsNamed) {
    const MemoryNeeds needs = {.scene_bytes = 3 << 20,
                               .structure_bytes = 5 << 20,
                               .film_bytes = 7 << 20,
                               .slot_bytes = 200};
    expect_refusal(
        (15 << 20) + 31 * 200, needs,
        {"structure over its triangles 5.00 MiB, the film", "a smaller image, or --accel none."});
    EXPECT_EQ(pool_that_fits((15 << 20) + 32 * 200, needs, 5000), 32);
}

} // namespace

} // namespace raylab
