// FURN-RAD, FURN-1000, POINT-IN-SPHERE: rooms whose light is a geometric series.
//
// In a closed room that glows with e and reflects a everywhere, the k-th surface of any path adds
// e a^k: d surfaces give e (1 - a^d) / (1 - a), without noise.
#include "app/tests/accuracy.h"

namespace raylab::app {

namespace {

double series(double a, int d) { return a == 1 ? d : (1 - std::pow(a, d)) / (1 - a); }

// The albedo as the renderer has it, in single precision.
double rounded(double a) { return static_cast<float>(a); }

Scene furnace(const std::string& shape, DVec3 albedo, int depth, bool roulette, int side) {
    return parse(
        {.camera = camera({0.3, 0.2, 0.1}, {1, 0, 0}, 60),
         .materials = R"("wall": )" + diffuse(albedo, DVec3(1)),
         .shapes = shape,
         .render = fmt::format(
             R"("max_depth": {}, "roulette": {}, "direct_light": "bsdf", "sampler": "independent")",
             depth, roulette),
         .width = side,
         .height = side});
}

const std::string unit_sphere = sphere(DVec3(0), 1, "wall");

TEST_P(EachLab, FurnRadEveryPixelIsTheSumOfTheSeries) {
    const double albedo[3] = {0.5, 0.9, 0.99};
    for (const auto& [name, shape] :
         {std::pair<std::string, std::string>{"sphere", unit_sphere},
          {"box", box({-1, -1, -2}, {1, 1.5, 1}, "wall")},
          {"turned box",
           box({-1, -1, -2}, {1, 1.5, 1}, "wall",
               R"(, "transform": {"rotate": [{"axis": [1, 2, 3], "angle_deg": 40}]})")}}) {
        Scene scene = furnace(shape, {0.5, 0.9, 0.99}, 50, false, 16);
        const Film film = trace(GetParam(), scene, count(4, 64)).film;
        scene.materials[0].reflectance *= 1.0001f; // the planted error
        const Film brighter = trace(GetParam(), scene, 1).film;
        for (int c = 0; c < 3; ++c) {
            const double truth = series(rounded(albedo[c]), 50);
            figure("FURN-RAD", GetParam(), fmt::format("{}, a = {}", name, albedo[c]),
                   worst_pixel(film, truth, c), 1e-5, worst_pixel(brighter, truth, c));
        }
    }
}

TEST_P(EachLab, Furn1000AThousandSurfacesWithoutRoulette) {
    const double albedo[3] = {0.99, 0.999, 1};
    const Scene scene = furnace(unit_sphere, {0.99, 0.999, 1}, 1000, false, 8);
    const Film film = trace(GetParam(), scene, count(2, 64)).film;
    const Film shorter =
        trace(GetParam(), furnace(unit_sphere, {0.99, 0.999, 1}, 990, false, 1), 1).film;
    for (int c = 1; c < 3; ++c) // at a = 0.99 the last ten surfaces add only 4e-6
        EXPECT_GT(worst_pixel(shorter, series(rounded(albedo[c]), 1000), c), 1e-5);
    for (int c = 0; c < 3; ++c)
        figure("FURN-1000", GetParam(), fmt::format("no roulette, a = {}", albedo[c]),
               worst_pixel(film, series(rounded(albedo[c]), 1000), c), 1e-5);
}

TEST_P(EachLab, Furn1000RouletteKeepsTheMean) {
    for (const auto& [a, spp] : {std::pair{0.99, 64}, {0.999, 16}, {1.0, 2}}) {
        const Scene scene = furnace(unit_sphere, DVec3(a), 1000, true, 8);
        const Traced traced = trace(GetParam(), scene, count(spp, 64 * spp));
        const Estimate found = estimate(traced.film);
        const double truth = series(rounded(a), 1000);
        figure("FURN-1000", GetParam(), fmt::format("roulette, a = {}: off, in parts", a),
               std::fabs(found.mean / truth - 1), 1e-5 + 4 * found.error / truth);
        // Without the factor 1 / q a path that survives with probability a counts a^2 a surface.
        if (a < 1) {
            EXPECT_GT(std::fabs(series(a * a, 1000) / truth - 1), 1e-5 + 4 * found.error / truth);
            EXPECT_GT(paths_that(traced, PathEnd::roulette), 0);
        }
    }
}

// Ten thousand surfaces: the deepest path a scene may ask for. The recursive lab's stack must hold.
TEST_P(EachLab, Furn1000TenThousandSurfaces) {
    const Scene scene = furnace(unit_sphere, {0.99, 0.999, 1}, max_path_depth, false, 2);
    const Traced traced = trace(GetParam(), scene, 1);
    for (const PathRecord& record : traced.records) EXPECT_EQ(record.length, max_path_depth);
    const double albedo[3] = {0.99, 0.999, 1};
    for (int c = 0; c < 3; ++c)
        figure("FURN-1000", GetParam(), fmt::format("d = 10000, a = {}", albedo[c]),
               worst_pixel(traced.film, series(rounded(albedo[c]), max_path_depth), c), 5e-5);
}

// A point light of intensity pi r^2 at the centre sends pi to every point of the wall: it reflects
// a / pi * pi = a at once, and every further bounce a times that: a / (1 - a) = 1 for a = 1 / 2.
TEST_P(EachLab, PointInSphereEveryPixelIsOne) {
    for (const double r : {1e-3, 1.0, 1e3}) {
        const auto lit = [&](double intensity) {
            return parse({.camera = camera(r * DVec3(0.3, 0.2, -0.1), {-r, 0, 0}, 75),
                          .materials = R"("wall": )" + diffuse(DVec3(0.5)),
                          .shapes = sphere(DVec3(0), r, "wall"),
                          .lights = fmt::format(
                              R"({{"kind": "point", "position": [0, 0, 0], "intensity": {}}})",
                              text(DVec3(intensity * r * r))),
                          .render = R"("max_depth": 40, "roulette": false)",
                          .width = 16,
                          .height = 16});
        };
        const Film film = trace(GetParam(), lit(M_PI), count(4, 64)).film;
        figure("POINT-IN-SPHERE", GetParam(), fmt::format("radius {}", r), worst_pixel(film, 1),
               1e-4, worst_pixel(trace(GetParam(), lit(3.142), 1).film, 1));
    }
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
