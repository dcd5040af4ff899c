// The pool and the memory: figures that can be added up, a pool that shrinks, a refusal that says
// why.
#include "common/task/small_scene.h"
#include "labs/03_wavefront/memory_budget.h"
#include "labs/03_wavefront/pool.h"
#include "labs/03_wavefront/renderer.h"

#include <gtest/gtest.h>

namespace raylab::lab03 {

namespace {

// Every array of a pool, by what it takes: the sum is what path_bytes says.
TEST(Memory, APathTakesWhatIsStated) {
    const PoolView p{};
    EXPECT_EQ(path_bytes, sizeof *p.pixel + sizeof *p.bounce + sizeof *p.throughput +
                              sizeof *p.radiance + sizeof *p.bsdf_pdf + sizeof *p.alive +
                              sizeof *p.record + sizeof *p.origin + sizeof *p.direction +
                              sizeof *p.hit + sizeof *p.kind + sizeof *p.shadow_ray_origin +
                              sizeof *p.shadow_ray_direction + sizeof *p.shadow_ray_t_max +
                              sizeof *p.shadow_ray_light);
    EXPECT_EQ(branch_bytes(0), 0u);
    EXPECT_EQ(branch_bytes(7), sizeof *p.node + sizeof *p.pending + 7 * sizeof *p.stack);
}

TEST(Memory, ThePoolShrinksToWhatIsLeft) {
    const MemoryNeeds needs = {.scene_bytes = 1000, .film_bytes = 7000, .slot_bytes = 200};
    EXPECT_EQ(pool_that_fits(1 << 30, needs, 5000), 5000);
    EXPECT_EQ(pool_that_fits(8000 + 200 * 100, needs, 5000), 100);
    EXPECT_EQ(pool_that_fits(8000 + 200 * 101 - 1, needs, 5000), 100);
    EXPECT_EQ(pool_that_fits(8000 + 200, needs, 1), 1) << "an image of one pixel needs one path";
    // The lecture's 1.5 GB.
    EXPECT_EQ(pool_that_fits(1610612736, needs, 1 << 28), (1610612736 - 8000) / 200);
}

TEST(Memory, WhatCannotFitIsRefusedWithTheFigures) {
    const MemoryNeeds needs = {.scene_bytes = 3 << 20, .film_bytes = 7 << 20, .slot_bytes = 200};
    for (const std::int64_t budget : {std::int64_t{1}, std::int64_t{10} << 20}) {
        try {
            pool_that_fits(budget, needs, 5000);
            FAIL() << "a budget of " << budget << " bytes is too small";
        } catch (const SettingsError& error) {
            const std::string text = error.what();
            for (const char* figure : {"3.00 MiB", "7.00 MiB", "200 bytes", "32 paths"})
                EXPECT_NE(text.find(figure), std::string::npos) << text;
        }
    }
}

TEST(Memory, ARendererKeepsToItsBudget) {
    const Scene scene =
        task::small_scene({.materials = "", .shapes = "", .width = 256, .height = 256});
    const auto pool_with = [&](std::int64_t budget) {
        const auto renderer = make_renderer(scene, {.wavefront = {.memory_budget = budget}});
        renderer->add_iteration();
        for (const FilmPixel& pixel : renderer->film().pixels) EXPECT_EQ(pixel.samples, 1u);
        return renderer->ledger().pool_paths;
    };
    EXPECT_EQ(pool_with(0), 256 * 256);
    const int small = pool_with(6 << 20);
    EXPECT_GT(small, 1000);
    EXPECT_LT(small, 20000);
    EXPECT_THROW(pool_with(1 << 20), SettingsError);
}

} // namespace

} // namespace raylab::lab03
