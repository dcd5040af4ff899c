// Tasks 2.2 and 2.3: one sample in every pixel, added up, however the launch is cut into blocks.
#include "common/task/facts.h"
#include "labs/02_iterative/tests/small_renders.h"

#include <algorithm>

namespace raylab::lab02 {

namespace {

using namespace task;

struct Drawn {
    int width, height, block;
};

std::string text(const Drawn& drawn) {
    return fmt::format("pixels of {} x {} in blocks of {} threads", drawn.width, drawn.height,
                       drawn.block);
}

// Whole warps of pixels: a warp that is not full is task 2.6's matter. The film of so many has a
// multiple of 256 bytes, and the CPU machine ends a kernel that writes behind such an array.
TEST(Task2_2, EveryPixelHasItsThread) {
    for (const Drawn& drawn :
         {Drawn{32, 7, 32}, {31, 32, 128}, {20, 16, 100}, {64, 2, 128}, {8, 4, 1}, {4, 8, 1024}}) {
        Film film(1, 1);
        const std::string error = error_of(
            [&] { film = render(sky(drawn.width, drawn.height), {.block_size = drawn.block}, 1); });
        if (!expect(error.empty(),
                    fmt::format("{} end with an error; the likely cause: a thread has a pixel if "
                                "thread < pixels, all others return -1 and write nothing. {}",
                                text(drawn), error)))
            return;
        const auto empty = std::count_if(film.pixels.begin(), film.pixels.end(),
                                         [](const FilmPixel& p) { return p.samples == 0; });
        const auto twice = std::count_if(film.pixels.begin(), film.pixels.end(),
                                         [](const FilmPixel& p) { return p.samples > 1; });
        if (!expect_equal(text(drawn) + " that no thread drew", empty, 0,
                          "too few blocks (round up!), or the thread's number is not blockIdx.x * "
                          "blockDim.x + threadIdx.x") ||
            !expect_equal(text(drawn) + " that several threads drew", twice, 0,
                          "two threads have the same number"))
            return;
    }
}

TEST(Task2_3, IterationsAddUp) {
    const Scene scene = sky(16, 4);
    const std::unique_ptr<Renderer> renderer = make_renderer(scene, {});
    for (int n = 1; n <= 3; ++n) {
        renderer->add_iteration();
        const FilmPixel pixel = renderer->film().pixels[22];
        const auto what = [&](const std::string& sum) {
            return fmt::format("{} of a pixel under a sky of (1, 2, 3), after {} iteration{}", sum,
                               n, n == 1 ? "" : "s");
        };
        if (!expect_equal(what("number of samples"), pixel.samples, n,
                          "each iteration adds one sample to what the film has") ||
            !expect_vector(what("sum"), DVec3(pixel.sum[0], pixel.sum[1], pixel.sum[2]),
                           double(n) * DVec3(1, 2, 3), 1e-5,
                           n == 1 ? "the film gets the sample as it is, in each channel: neither "
                                    "clamped nor corrected for a display"
                                  : "samples are added, not put in place, and as they are: "
                                    "develop() divides by their number") ||
            !expect_near(what("sum of squares of green"), pixel.sum_squares[1], 4 * n, 1e-5,
                         "add_sample() keeps both sums"))
            return;
    }
}

TEST(Task2_3, EachPathLeavesItsRecord) {
    const Scene scene = sky(16, 4);
    const std::unique_ptr<Renderer> renderer = make_renderer(scene, {});
    renderer->add_iteration();
    const std::vector<PathRecord> records = renderer->records();
    const auto escaped = std::count_if(records.begin(), records.end(), [](const PathRecord& r) {
        return r.length == 1 && r.end == PathEnd::escaped;
    });
    expect_equal("records of 64 that tell of one ray that escaped", escaped, 64,
                 "records[pixel] = record");
}

} // namespace

} // namespace raylab::lab02
