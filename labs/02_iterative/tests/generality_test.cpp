// What generality costs: the box, traced by kernels that can do more than the box needs.
//
// Each kernel has one more feature compiled in; the box uses none of them, so all draw the same
// image. The variant that the lab chooses for the box has exactly its features and pays nothing.
#include "common/load/load.h"
#include "common/scene/scene_features.h"
#include "common/scene/variants.h"
#include "labs/02_iterative/tests/plain_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace raylab::lab02 {

namespace {

struct Contestant {
    const char* name;
    decltype(&plain_loop<variant::matte>) trace;
    std::vector<FilmPixel> film = std::vector<FilmPixel>(256 * 256);
    std::vector<double> ratios = {}; // of time, to the specialised kernel in the same round
};

template <Features added> Contestant with(const char* name) {
    return {name, plain_loop<variant::matte | added>};
}

TEST(Generality, CostsNothingAfterSpecialisation) {
    Scene scene = load_scene(find_scene("cornell_peers"));
    set_film_size(scene.camera, 256, 256);
    ASSERT_EQ(features_of(scene), variant::matte) << "the kernel that draws the box has more in it";

    Contestant contestants[] = {
        with<0>("specialised"),
        with<0>("specialised, again"),
        with<feature::sphere>("sphere"),
        with<feature::plane>("plane"),
        with<feature::triangle | feature::corners>("mesh"),
        with<feature::texture>("textures"),
        with<feature::mirror>("mirror"),
        with<feature::glass>("glass"),
        with<feature::phong>("phong"),
        with<feature::conductor | feature::rough_dielectric>("microfacet"),
        with<feature::lens>("lens"),
        with<feature::point_light>("point lights"),
        with<feature::environment | feature::environment_map>("environment"),
        {"classic", plain_loop<variant::classic>},
        {"everything", plain_loop<variant::everything>},
    };
    const bool in_full = std::getenv("RAYLAB_LONG") != nullptr;
    const int threads = static_cast<int>(std::thread::hardware_concurrency());
    std::vector<PathRecord> records(256 * 256);
    for (int round = 0; round < (in_full ? 15 : 1); ++round) {
        double specialised = 0;
        for (Contestant& c : contestants) {
            const double time = seconds([&] {
                for (std::uint32_t i = 0; i < (in_full ? 4u : 1u); ++i)
                    c.trace(view(scene), scene.render, i, threads, c.film, records);
            });
            if (&c == contestants) specialised = time;
            c.ratios.push_back(time / specialised);
        }
    }
    for (Contestant& c : contestants) {
        std::sort(c.ratios.begin(), c.ratios.end());
        const std::size_t n = c.ratios.size();
        std::printf("%-20s %.3f (%.3f to %.3f)\n", c.name, c.ratios[n / 2], c.ratios[n / 4],
                    c.ratios[n - 1 - n / 4]);
        EXPECT_EQ(std::memcmp(c.film.data(), contestants[0].film.data(),
                              c.film.size() * sizeof(FilmPixel)),
                  0)
            << c.name << " changes the image";
    }
    if (in_full) {
        EXPECT_NEAR(contestants[1].ratios[7], 1, 0.02) << "this machine is too noisy";
    }
}

} // namespace

} // namespace raylab::lab02
