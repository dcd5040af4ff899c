// The pool and the memory.
#include "common/task/small_scene.h"
#include "labs/03_wavefront/renderer.h"

#include <gtest/gtest.h>

namespace raylab::lab03 {

namespace {

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
