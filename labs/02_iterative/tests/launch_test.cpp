// Tasks 2.2 to 2.4: one sample in every pixel, added up, from random numbers that belong to the
// path: whichever threads, blocks and order the launch has.
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/02_iterative/renderer.h"

#include <algorithm>
#include <cstring>

namespace raylab::lab02 {

namespace {

using namespace task;

Film render(const Scene& scene, const MachineSettings& machine, int iterations) {
    const std::unique_ptr<Renderer> renderer = make_renderer(scene, machine);
    for (int i = 0; i < iterations; ++i) renderer->add_iteration();
    return renderer->film();
}

// Nothing but sky: every sample is (1, 2, 3).
Scene sky(int width, int height) {
    return small_scene({.materials = R"("a": {"kind": "mirror", "reflectance": [1, 1, 1]})",
                        .shapes = "",
                        .lights = R"({"kind": "environment", "radiance": [1, 2, 3]})",
                        .width = width,
                        .height = height});
}

// A floor that fills the view, unevenly lit: every pixel is noisy.
Scene noisy(int side, int seed) {
    return small_scene(
        {.materials = R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
            "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [3, 3, 3]})",
         .shapes =
             R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "material": "floor"},
            {"kind": "quad", "material": "lamp",
             "vertices": [[-3, 3, 1], [3, 3, 1], [3, 4, 4], [-3, 4, 4]]})",
         .render = fmt::format(R"("max_depth": 3, "spp": 1, "seed": {})", seed),
         .camera = R"("position": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 2)",
         .width = side,
         .height = side});
}

TEST(Task2_2, EveryPixelHasItsThread) {
    const struct {
        int width, height, block;
    } cases[] = {{1, 1, 128}, {33, 7, 32}, {31, 17, 128}, {20, 10, 100}, {64, 2, 128}, {5, 3, 1}};
    for (const auto& [width, height, block] : cases) {
        const Film film = render(sky(width, height), {.block_size = block}, 1);
        const auto empty = std::count_if(film.pixels.begin(), film.pixels.end(),
                                         [](const FilmPixel& p) { return p.samples == 0; });
        const auto twice = std::count_if(film.pixels.begin(), film.pixels.end(),
                                         [](const FilmPixel& p) { return p.samples > 1; });
        const std::string what =
            fmt::format("pixels of {} x {} in blocks of {} threads", width, height, block);
        if (!expect_equal(what + " that no thread drew", empty, 0,
                          "too few blocks (round up!), or the thread's number is not blockIdx.x * "
                          "blockDim.x + threadIdx.x") ||
            !expect_equal(what + " that several threads drew", twice, 0,
                          "two threads have the same number"))
            return;
    }
}

TEST(Task2_3, IterationsAddUp) {
    const std::unique_ptr<Renderer> renderer = [] {
        static const Scene scene = sky(9, 5);
        return make_renderer(scene, {});
    }();
    for (int n = 1; n <= 3; ++n) {
        renderer->add_iteration();
        const FilmPixel pixel = renderer->film().pixels[22];
        if (!expect_equal(fmt::format("samples of a pixel after {} iterations", n), pixel.samples,
                          n, "each iteration adds one sample to what the film has") ||
            !expect_near(fmt::format("its sum of green, under a sky of 2, after {} iterations", n),
                         pixel.sum[1], 2 * n, 1e-6, "samples are added, not put in place") ||
            !expect_near("its sum of squares", pixel.sum_squares[1], 4 * n, 1e-6,
                         "add_sample() keeps both sums"))
            return;
    }
}

TEST(Task2_3, EachPathLeavesItsRecord) {
    const Scene scene = sky(9, 5);
    const std::unique_ptr<Renderer> renderer = make_renderer(scene, {});
    renderer->add_iteration();
    const std::vector<PathRecord> records = renderer->records();
    const auto escaped = std::count_if(records.begin(), records.end(), [](const PathRecord& r) {
        return r.length == 1 && r.end == PathEnd::escaped;
    });
    expect_equal("records of 45 that tell of one ray that escaped", escaped, 45,
                 "records[pixel] = record");
}

TEST(Task2_4, TheLaunchDoesNotChangeTheImage) {
    const Scene scene = noisy(24, 1);
    const Film film = render(scene, {.threads = 1, .block_size = 128}, 2);
    const std::string cause = "random numbers keyed by pixel and sample, never by threadIdx or a "
                              "generator that threads share";
    expect(same_bits(render(scene, {.threads = 2, .block_size = 32}, 2), film),
           "the image in blocks of 32 should have the same bits as in blocks of 128; the likely "
           "cause: " +
               cause);
    expect(same_bits(render(scene, {.threads = 2, .order = ThreadOrder::reverse}, 2), film),
           "the image with threads in reverse order should have the same bits; the likely cause: " +
               cause);
}

TEST(Task2_4, EveryPixelSampleAndSeedHasNumbersOfItsOwn) {
    const Film one = render(noisy(24, 1), {}, 1), two = render(noisy(24, 1), {}, 2),
               other = render(noisy(24, 2), {}, 1);
    std::vector<double> values;
    int repeated = 0, like_other_seed = 0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
        const double first = one.pixels[i].sum[0];
        values.push_back(first);
        repeated += two.pixels[i].sum[0] - first == first;
        like_other_seed += other.pixels[i].sum[0] == first;
    }
    std::sort(values.begin(), values.end());
    const auto distinct = std::unique(values.begin(), values.end()) - values.begin();
    // Two of 576 floats are equal by chance about once in a hundred images, 57 of them never.
    expect(distinct >= 519,
           fmt::format("576 pixels of a noisy image have only {} different values; the likely "
                       "cause: the pixel's number does not enter the random numbers",
                       distinct));
    expect(repeated <= 57,
           fmt::format("the second sample of {} of 576 pixels repeats the first; the likely "
                       "cause: the sample's number does not enter the random numbers",
                       repeated));
    expect(like_other_seed <= 57,
           fmt::format("{} of 576 pixels are the same with another seed; the likely cause: the "
                       "seed does not enter the random numbers",
                       like_other_seed));
}

// Noise has no pattern: the correlation of n independent pairs is 0 with standard error 1/sqrt(n).
// 4.5 of these: a false alarm in 147,000.
TEST(Task2_4, NeighboursAreIndependent) {
    constexpr int side = 32;
    const Film film = render(noisy(side, 3), {}, 1);
    const auto correlation = [&](int dx, int dy) {
        double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
        for (int y = 0; y + dy < side; ++y)
            for (int x = 0; x + dx < side; ++x) {
                const double p = film.pixels[y * side + x].sum[0];
                const double q = film.pixels[(y + dy) * side + x + dx].sum[0];
                n += 1, a += p, b += q, aa += p * p, bb += q * q, ab += p * q;
            }
        return (n * ab - a * b) / std::sqrt((n * aa - a * a) * (n * bb - b * b));
    };
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {16, 0}})
        expect_near(fmt::format("correlation of pixels ({}, {}) apart", dx, dy),
                    correlation(dx, dy), 0, 4.5 / side + 0.02,
                    "numbers of neighbouring pixels resemble each other: hash the key, or seeds "
                    "that differ by one give streams that differ by little");
}

} // namespace

} // namespace raylab::lab02
