// Task 3.1: the pool and its stages. Truth from closed forms and from the paths' own records; what
// must not matter (pool, blocks, order of slots, queues) must not change a bit. Compaction is task
// 3.3 and stays off.
#include "common/render/render.h"
#include "common/scene/sphere_groups.h"
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/03_wavefront/renderer.h"

#include <algorithm>
#include <cstring>

namespace raylab::lab03 {

namespace {

using namespace task;

struct Traced {
    Film film;
    Ledger ledger;
    std::vector<PathRecord> records;
};

Traced trace(const Scene& scene, WavefrontSettings wavefront = {}, int iterations = 1,
             int block = 128) {
    wavefront.compact_every = 0;
    const std::unique_ptr<Renderer> renderer =
        make_renderer(scene, {.threads = 1, .block_size = block, .wavefront = wavefront});
    for (int i = 0; i < iterations; ++i) renderer->add_iteration();
    return {renderer->film(), develop(*renderer, scene).ledger, renderer->records()};
}

// Inside a closed sphere that glows with radiance 1 and reflects a share a of what it gets.
Scene furnace(double albedo, int depth, int width = 16, int height = 16) {
    return small_scene(
        {.materials = fmt::format(R"("wall": {{"kind": "diffuse", "reflectance": [{0}, {0}, {0}],
                                       "emission": [1, 1, 1]}})",
                                  albedo),
         .shapes = R"({"kind": "sphere", "center": [0, 0, 0], "radius": 6, "material": "wall"})",
         .render = fmt::format(
             R"("max_depth": {}, "spp": 1, "direct_light": "bsdf", "roulette": false)", depth),
         .width = width,
         .height = height});
}

// A room with four kinds of material, lamps and an open side: paths of all lengths and ends.
Scene room(const std::string& integrator = "path", int width = 33, int height = 21) {
    return small_scene(
        {.materials = R"("wall": {"kind": "diffuse", "reflectance": [0.7, 0.6, 0.5]},
            "mirror": {"kind": "mirror", "reflectance": [0.9, 0.9, 0.9]},
            "glass": {"kind": "glass", "ior": 1.5},
            "shiny": {"kind": "phong", "reflectance": [0.3, 0.2, 0.1],
                      "specular": [0.4, 0.4, 0.4], "exponent": 30},
            "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [9, 8, 7]})",
         .shapes = R"(
            {"kind": "plane", "point": [0, -2, 0], "normal": [0, 1, 0], "material": "wall"},
            {"kind": "plane", "point": [0, 0, -4], "normal": [0, 0, 1], "material": "shiny"},
            {"kind": "sphere", "center": [-1, -1, 0], "radius": 1, "material": "mirror"},
            {"kind": "sphere", "center": [1, -1, 0.5], "radius": 1, "material": "glass"},
            {"kind": "quad", "vertices": [[-1, 3, -1], [1, 3, -1], [1, 3, 1], [-1, 3, 1]],
             "material": "lamp"})",
         .lights = R"({"kind": "point", "position": [3, 3, 3], "intensity": [5, 5, 5]})",
         .render = fmt::format(R"("integrator": "{}", "max_depth": 7, "spp": 1)", integrator),
         .width = width,
         .height = height});
}

TEST(Task3_1, EveryPixelGetsOneSampleOfTheSky) {
    const struct {
        int width, height, pool, block;
    } cases[] = {{1, 1, 1 << 20, 128}, {5, 3, 1, 32}, {33, 7, 100, 64}, {31, 17, 64, 100}};
    for (const auto& [width, height, pool, block] : cases) {
        const Scene sky =
            small_scene({.materials = R"("a": {"kind": "mirror", "reflectance": [1, 1, 1]})",
                         .shapes = "",
                         .lights = R"({"kind": "environment", "radiance": [1, 2, 3]})",
                         .width = width,
                         .height = height});
        const Film film = trace(sky, {.pool = pool}, 2, block).film;
        const auto wrong =
            std::count_if(film.pixels.begin(), film.pixels.end(), [](const FilmPixel& p) {
                return p.samples != 2 || p.sum[0] != 2 || p.sum[2] != 6;
            });
        if (!expect_equal(fmt::format("pixels of {} x {} in a pool of {}, blocks of {}, that have "
                                      "not 2 samples of the sky (1, 2, 3)",
                                      width, height, pool, block),
                          wrong, 0,
                          "accumulate_path() adds each path once, also those that ended early, to "
                          "the pixel that it belongs to, pool.pixel[slot]"))
            return;
    }
}

// e (1 - a^d) / (1 - a), without noise: one surface too many or too few, or one factor, shows.
TEST(Task3_1, AClosedFurnaceGivesItsSeries) {
    for (const int depth : {1, 2, 5, 50}) {
        const Film film = trace(furnace(0.5, depth), {.pool = 77}).film;
        for (const FilmPixel& pixel : film.pixels)
            if (!expect_near(fmt::format("radiance in a furnace of albedo 0.5 at depth {}", depth),
                             pixel.sum[1], 2 * (1 - std::pow(0.5, depth)), 2e-5,
                             depth == 1 ? "emission counts at the last surface too"
                                        : "throughput *= weight; the path ends at max_depth "
                                          "surfaces, with end_path()"))
                return;
    }
}

// Thousands of bounces: nothing drifts, nothing runs over.
TEST(Task3_1, FurnacesHoldAtDepthOneThousand) {
    for (const double albedo : {0.99, 1.0}) {
        const double truth = albedo == 1 ? 1000 : (1 - std::pow(albedo, 1000)) / (1 - albedo);
        const Traced traced = trace(furnace(albedo, 1000, 4, 4));
        for (const FilmPixel& pixel : traced.film.pixels)
            if (!expect_near(
                    fmt::format("radiance in a furnace of albedo {} at depth 1000", albedo),
                    pixel.sum[1] / truth, 1, 2e-5, "float sums over 1000 bounces"))
                return;
        expect_equal("paths alive in bounce 999",
                     static_cast<long long>(traced.ledger.bounces[999].rays), 16,
                     "no path ends before max_depth in a closed room without roulette");
    }
}

// E = I / r^2 straight below a point light, and a shadow where something is in the way.
TEST(Task3_1, ShadowRaysFindLightAndShadow) {
    const auto below = [](const std::string& blocker) {
        const Scene scene = small_scene(
            {.materials = R"("floor": {"kind": "diffuse", "reflectance": [1, 1, 1]})",
             .shapes =
                 R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "material": "floor"})" +
                 blocker,
             .lights = R"({"kind": "point", "position": [0, 0, 2], "intensity": [4, 4, 4]})",
             .camera =
                 R"("position": [0, 0, 1], "look_at": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 0.1)",
             .width = 1,
             .height = 1});
        return trace(scene).film.pixels[0].sum[0];
    };
    expect_near("radiance of a white floor 2 below a point light of intensity 4", below(""),
                1 / 3.14159265, 1e-5,
                "shadow_path() adds shadow_ray_light, which has the throughput");
    expect_near("the same behind a sphere",
                below(R"(, {"kind": "sphere", "center": [0, 0, 1.5], "radius": 0.2,
                          "material": "floor"})"),
                0, 0, "shadow_path() must ask occluded()");
    expect_near("the same with a wall behind the light",
                below(R"(, {"kind": "plane", "point": [0, 0, 3], "normal": [0, 0, -1],
                          "material": "floor"})"),
                1 / 3.14159265, 1e-5,
                "what lies behind the light is not in its way: shadow_ray_of() has a t_max");
}

// A point light in the middle of a grey sphere: every surface gets g = (a / pi) I / r^2 from it,
// and passes a share a on, so L = g (1 + a + ... + a^(d-2)): light found at surface k counts as k
// + 1.
TEST(Task3_1, EveryBounceFindsTheLampWeightedByItsThroughput) {
    for (const int depth : {2, 3, 8}) {
        const Scene scene = small_scene(
            {.materials = R"("wall": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})",
             .shapes =
                 R"({"kind": "sphere", "center": [0, 0, 0], "radius": 6, "material": "wall"})",
             .lights = fmt::format(
                 R"({{"kind": "point", "position": [0, 0, 0], "intensity": [{0}, {0}, {0}]}})",
                 36 * 3.14159265358979),
             .render = fmt::format(R"("max_depth": {}, "spp": 1, "roulette": false)", depth),
             .width = 4,
             .height = 4});
        const double truth = 1 - std::pow(0.5, depth - 1);
        for (const FilmPixel& pixel : trace(scene).film.pixels)
            if (!expect_near(
                    fmt::format("radiance around a point light in a grey sphere at depth {}",
                                depth),
                    pixel.sum[1], truth, 1e-4,
                    "shadow_ray_light = throughput * shadow_ray.light, and none from the last "
                    "surface"))
                return;
    }
}

// The same with Russian roulette, which must not change the mean. A path that ends still sends the
// shadow ray of its last surface, and each bounce has random numbers of its own.
TEST(Task3_1, RouletteChangesNoMean) {
    const Scene scene = small_scene(
        {.materials = R"("wall": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})",
         .shapes = R"({"kind": "sphere", "center": [0, 0, 0], "radius": 6, "material": "wall"})",
         .lights = fmt::format(
             R"({{"kind": "point", "position": [0, 0, 0], "intensity": [{0}, {0}, {0}]}})",
             36 * 3.14159265358979),
         .render = R"("max_depth": 30, "spp": 1)",
         .width = 64,
         .height = 64});
    Samples samples;
    for (const FilmPixel& pixel : trace(scene).film.pixels) samples.add(pixel.sum[1]);
    expect_near("mean radiance around a point light in a grey sphere, with roulette",
                samples.mean(), 1, Samples::allowed * samples.error(),
                "a path that roulette ends must still return its shadow ray");
}

// The paths themselves, counted from their records: the ledger must agree.
TEST(Task3_1, TheLedgerCountsEveryPathOnce) {
    const Traced traced = trace(room(), {.pool = 200});
    std::vector<std::uint64_t> rays(8);
    std::uint64_t shadow_rays = 0;
    for (const PathRecord& record : traced.records) {
        for (int b = 0; b < record.length && b < 8; ++b) ++rays[b];
        shadow_rays += record.shadow_rays;
    }
    expect_equal("paths in bounce 0", static_cast<long long>(rays[0]), 33 * 21,
                 "each path's record must reach the film: accumulate_path()");
    for (int b = 0; b < 7; ++b)
        expect_equal(fmt::format("rays of the ledger in bounce {}", b),
                     static_cast<long long>(traced.ledger.bounces[b].rays),
                     static_cast<long long>(rays[b]), "record_hit() once a ray");
    expect_equal("shadow rays", static_cast<long long>(traced.ledger.shadow_rays),
                 static_cast<long long>(shadow_rays), "one shadow ray for each that was sent");
}

// POOL-INVAR: how the pool is run changes no bit.
TEST(Task3_1, NothingAboutThePoolChangesABit) {
    for (const char* integrator : {"path", "whitted"}) {
        const Scene scene = room(integrator);
        const Traced plain = trace(scene, {}, 2);
        const auto dark = std::count_if(plain.film.pixels.begin(), plain.film.pixels.end(),
                                        [](const FilmPixel& p) { return p.sum[0] == 0; });
        if (!expect(dark < 33 * 21 / 2, "most of the image is black")) return;
        for (const WavefrontSettings& w :
             {WavefrontSettings{.pool = 1}, WavefrontSettings{.pool = 97, .shuffle = 3},
              WavefrontSettings{.sort = MaterialSort::queues, .pool = 300}})
            for (const int block : {32, 224, 1024})
                if (!expect(same_bits(trace(scene, w, 2, block).film, plain.film),
                            fmt::format("{}: the image changes with a pool of {}, shuffle {}, "
                                        "blocks of {}; the likely cause: something is keyed by the "
                                        "slot or the thread, not by the pixel",
                                        integrator, w.pool, w.shuffle, block)))
                    return;
    }
}

// NAN-POISON: a sample that is not finite is counted and harms no other pixel.
TEST(Task3_1, NotFiniteSamplesAreCountedAndKeptOut) {
    Scene scene = room();
    const Film clean = trace(scene).film;
    for (Material& material : scene.materials)
        if (material.kind == MaterialKind::phong) material.reflectance.x = NAN;
    const Traced poisoned = trace(scene, {.pool = 100});
    const std::vector<PathRecord> records = poisoned.records;
    int rejected = 0;
    for (std::size_t i = 0; i < clean.pixels.size(); ++i) {
        const FilmPixel& pixel = poisoned.film.pixels[i];
        rejected += static_cast<int>(pixel.rejected);
        for (const double sum : pixel.sum)
            if (!expect(std::isfinite(sum), fmt::format("the film has a NaN in pixel {}", i)))
                return;
        if (!expect_equal(fmt::format("samples and rejected samples of pixel {}", i),
                          pixel.samples + pixel.rejected, 1, "add_sample() once a path"))
            return;
    }
    expect(rejected > 0, "no sample was rejected, though a wall's reflectance is NaN");
    expect_equal("rejected samples in the ledger", static_cast<long long>(poisoned.ledger.rejected),
                 rejected, "the ledger adds up the film's");
}

// POW2-SCALE: a scene 2^k times as large has the same image, to the bit.
TEST(Task3_1, ScalingByAPowerOfTwoChangesNoBit) {
    const Film unit = trace(furnace(0.7, 9)).film;
    for (const int k : {-20, 20}) {
        Scene scene = furnace(0.7, 9);
        const float scale = std::ldexp(1.0f, k);
        scene.camera.position *= scale;
        for (Sphere& sphere : scene.spheres) sphere.center *= scale, sphere.radius *= scale;
        scene.sphere_groups = group_spheres(scene.spheres);
        expect(same_bits(trace(scene).film, unit),
               fmt::format("a scene 2^{} times as large has another image; the likely cause: an "
                           "absolute epsilon",
                           k));
    }
}

// Paths that end in the first bounce, a single surface, a film that no block divides.
TEST(Task3_1, OddCasesDrawTheWholeImage) {
    const Traced none = trace(small_scene({.materials = "", .shapes = "", .width = 7}));
    expect_equal("rays of an empty scene", static_cast<long long>(none.ledger.bounces[0].rays),
                 7 * 16, "every path has one ray, and ends with it");
    expect_equal("of them alive in bounce 1", static_cast<long long>(none.ledger.bounces[1].rays),
                 0, "a miss ends the path");
    const Film odd = trace(furnace(0.5, 2, 799, 61), {.pool = 1021}, 1, 96).film;
    const auto wrong = std::count_if(odd.pixels.begin(), odd.pixels.end(), [](const FilmPixel& p) {
        return p.samples != 1 || std::fabs(p.sum[0] - 1.5) > 1e-5;
    });
    expect_equal("wrong pixels of a 799 x 61 furnace", wrong, 0,
                 "threads beyond the end of the list must return");
}

} // namespace

} // namespace raylab::lab03
