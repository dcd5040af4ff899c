// Task 3.4: the first-bounce cache changes no bit where it is right, and is refused where it is
// not.
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/03_wavefront/first_bounce_cache.h"
#include "labs/03_wavefront/renderer.h"

#include <cstring>

namespace raylab::lab03 {

namespace {

using namespace task;

Scene ball(bool jitter, const std::string& lens = "") {
    return small_scene(
        {.materials = R"("grey": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})",
         .shapes = R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "grey"})",
         .lights = R"({"kind": "environment", "radiance": [1, 2, 3]})",
         .render = fmt::format(R"("max_depth": 4, "spp": 1, "jitter": {})", jitter),
         .camera =
             R"("position": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 40)" +
             lens});
}

std::optional<std::string> no_cache(const Scene& scene) {
    return no_first_bounce_cache(scene.camera, scene.render);
}

Film render(const Scene& scene, bool cache) {
    const std::unique_ptr<Renderer> renderer = make_renderer(
        scene, {.threads = 1, .wavefront = {.pool = 100, .first_bounce_cache = cache}});
    for (int i = 0; i < 3; ++i) renderer->add_iteration();
    return renderer->film();
}

TEST(Task3_4, TheCacheChangesNoBitWhereCameraRaysStayTheSame) {
    const Scene scene = ball(false);
    const auto why_not = no_cache(scene);
    if (!expect(!why_not, "a pinhole without jitter is refused: " + why_not.value_or(""))) return;
    expect(same_bits(render(scene, true), render(scene, false)),
           "with the cache the image is another; the likely cause: hits of later bounces are kept "
           "too, or the cache is keyed by the slot and not by the pixel");
}

TEST(Task3_4, ItIsFilledOnceAndThenUsed) {
    Hit memory[3];
    int searches = 0;
    const auto search = [&] {
        ++searches;
        return Hit{static_cast<float>(searches), searches, Shape::sphere, 0};
    };
    const Hit first = cached_hit({memory, false}, 0, 1, search);
    expect_equal("searches for a pixel's first camera ray", searches, 1,
                 "the cache is not filled yet: search") &&
        expect_equal("the shape it hit", first.id, 1, "what was found is returned") &&
        expect_equal("the hit that is kept for pixel 1", memory[1].id, 1,
                     "what is found is kept in cache.hits[pixel]");
    cached_hit({memory, false}, 0, 2, search);
    const Hit again = cached_hit({memory, true}, 0, 1, search);
    expect_equal("searches for camera rays of two pixels, one of them in a second iteration",
                 searches, 2, "the second iteration takes cache.hits[pixel] and does not search") &&
        expect_equal("the shape that the pixel's ray hits again", again.id, 1,
                     "the hit of this pixel is kept, the whole of it: cache.hits[pixel]");
    cached_hit({memory, true}, 1, 1, search);
    expect_equal("searches after one more ray of bounce 1", searches, 3,
                 "only camera rays are the same each time");
}

TEST(Task3_4, WhatAnotherRenderLeftIsNotUsed) {
    Hit memory[2];
    memory[1] = {7, 7, Shape::sphere, 0}; // of another camera
    const Hit found = cached_hit({memory, false}, 0, 1, [] { return Hit{1, 1, Shape::quad, 0}; });
    expect_equal("the shape that a ray hits, where another camera's is kept", found.id, 1,
                 "cache.filled alone tells whether what is kept is of this camera");
    const Hit kept = cached_hit({memory, true}, 0, 1, [] { return Hit{2, 2, Shape::quad, 0}; });
    expect_equal("and in the next iteration", kept.id, 1, "what was found is kept");
    memory[0] = {};
    int searches = 0;
    cached_hit({memory, true}, 0, 0, [&] { return ++searches, Hit{}; });
    expect_equal("searches for a ray that is known to hit nothing", searches, 0,
                 "a miss is kept as well: cache.filled tells");
}

TEST(Task3_4, JitterAndLensesAreRefusedWithAReason) {
    const auto jitter = no_cache(ball(true));
    const auto lens = no_cache(ball(false, R"(, "lens_radius": 0.1, "focus_distance": 5)"));
    expect(jitter && jitter->find("jitter") != std::string::npos,
           "jittered camera rays differ each time, but the cache is not refused for it");
    expect(lens && lens->find("lens") != std::string::npos,
           "rays through a lens differ each time, but the cache is not refused for it");
    try {
        render(ball(true), true);
        expect(false, "a render with jitter and a first-bounce cache is not refused; the likely "
                      "cause: no_first_bounce_cache() returns no sentence");
    } catch (const SettingsError&) {
    }
}

// Why it is refused: with the middle of each pixel for all samples an edge stays jagged.
TEST(Task3_4, WithoutJitterEdgesStayJagged) {
    const auto between = [](const Film& film) {
        int count = 0;
        for (const FilmPixel& pixel : film.pixels) {
            const double mean = pixel.sum[0] / pixel.samples;
            count += mean > 0.75 && mean < 0.97;
        }
        return count;
    };
    const int jittered = between(render(ball(true), false)),
              middle = between(render(ball(false), false));
    expect(jittered > middle + 4,
           fmt::format("along the edge of a ball {} pixels are of its colour and the sky's, with "
                       "jitter, and {} without; the likely cause: the cache is used where it was "
                       "not asked for",
                       jittered, middle));
}

} // namespace

} // namespace raylab::lab03
