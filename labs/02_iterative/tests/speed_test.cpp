// What the CPU machine costs: lab 02 against the same device code in a plain threaded loop.
//
// Both trace the same samples of the same pixels with the same threads, in turns, so that a machine
// that slows down slows both; the median of the ratios counts. At most 1.10 is the aim.
#include "common/load/load.h"
#include "common/scene/scene_features.h"
#include "common/scene/variants.h"
#include "labs/02_iterative/renderer.h"
#include "labs/02_iterative/tests/plain_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace raylab::lab02 {

namespace {

double median_ratio_to_plain_loop(const std::string& name, int rounds, int iterations) {
    Scene scene = load_scene(find_scene(name));
    set_film_size(scene.camera, 256, 256);
    const int threads = static_cast<int>(std::thread::hardware_concurrency());
    const std::unique_ptr<Renderer> renderer = make_renderer(scene, {.threads = threads});
    std::vector<FilmPixel> film(256 * 256);
    std::vector<PathRecord> records(256 * 256);
    const SceneView host = view(scene);
    std::uint32_t sample = 0;

    std::vector<double> ratios;
    for (int round = 0; round < rounds; ++round) {
        const double machine = seconds([&] {
            for (int i = 0; i < iterations; ++i) renderer->add_iteration();
        });
        const double plain = seconds([&] {
            with_variant(features_of(scene), [&]<Features F>() {
                for (int i = 0; i < iterations; ++i)
                    plain_loop<F>(host, scene.render, sample++, threads, film, records);
            });
        });
        ratios.push_back(machine / plain);
    }
    // The two have drawn the same image, to the bit: the ratio compares like with like.
    const Film drawn = renderer->film();
    EXPECT_EQ(std::memcmp(drawn.pixels.data(), film.data(), film.size() * sizeof(FilmPixel)), 0);
    std::sort(ratios.begin(), ratios.end());
    std::printf("%s: CPU machine / plain loop: median %.3f (%.3f to %.3f)\n", name.c_str(),
                ratios[ratios.size() / 2], ratios.front(), ratios.back());
    return ratios[ratios.size() / 2];
}

TEST(Speed, CpuMachineCostsAtMostATenthMoreThanAPlainLoop) {
    const bool in_full = std::getenv("RAYLAB_LONG") != nullptr;
    for (const char* scene : {"cornell_peers", "cornell_spheres", "microfacets"}) {
        const double ratio = median_ratio_to_plain_loop(scene, in_full ? 15 : 3, in_full ? 8 : 2);
        // A machine that others share is too noisy for the figure; the quick run only looks for
        // the error of a whole order.
        EXPECT_LT(ratio, in_full ? 1.10 : 3.0) << scene;
    }
}

} // namespace

} // namespace raylab::lab02
