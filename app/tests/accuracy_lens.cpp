// LENS-COC: out of focus, a point becomes a disc of the lens's shape, and keeps its light.
//
// With aperture (diameter) A and focus distance f, a point at distance z blurs to a disc of
// diameter A |z - f| / z on the plane in focus. PBR4e 5.2.3.
#include "app/tests/accuracy.h"

namespace raylab::app {

namespace {

constexpr int side = 64;
constexpr double vfov = 40, focus = 2, aperture = 0.5;

// A glowing square at distance z that is 4 pixels wide: seen from any point of the lens it has the
// same size.
const double pixels_per_unit = side / (2 * std::tan(glm::radians(vfov / 2))); // at distance 1
constexpr double emitter = 4;

Scene point_at(double z, double lens_radius, double focus_distance) {
    const double s = emitter / pixels_per_unit * z / 2;
    return parse({.camera = camera({0, 0, 0}, {0, 0, -1}, vfov,
                                   lens_radius > 0
                                       ? fmt::format(R"(, "lens_radius": {}, "focus_distance": {})",
                                                     lens_radius, focus_distance)
                                       : ""),
                  .materials = R"("light": )" + diffuse(DVec3(0), DVec3(100)),
                  .shapes = quad({-s, -s, -z}, {s, -s, -z}, {s, s, -z}, {-s, s, -z}, "light"),
                  .render = R"("max_depth": 1, "sampler": "independent")",
                  .width = side,
                  .height = side});
}

// Mean squared distance from the middle of the film.
double second_moment(const Film& film) {
    double sum = 0, second = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double value = film.pixels[y * side + x].sum[0];
            const double dx = x + 0.5 - side / 2, dy = y + 0.5 - side / 2;
            sum += value;
            second += value * (dx * dx + dy * dy);
        }
    return second / sum;
}

// Blurring adds the disc's own second moment, R^2 / 2 for a uniform disc of radius R.
double diameter(const Film& blurred, const Film& sharp) {
    return 2 * std::sqrt(2 * std::max(0.0, second_moment(blurred) - second_moment(sharp)));
}

TEST_P(EachLab, LensCocDiscHasTheLensesDiameterAndKeepsItsLight) {
    for (const double z : {1.2, 1.5, 2.0, 3.0, 8.0}) {
        const int spp = count(128, 6400);
        const Film blurred = trace(GetParam(), point_at(z, aperture / 2, focus), spp).film;
        const Film sharp = trace(GetParam(), point_at(z, 0, focus), spp).film;
        // On the film, the disc is as wide as seen from the lens's middle on the plane in focus.
        const double truth = aperture * std::fabs(z - focus) / z / focus * pixels_per_unit;
        const double found = diameter(blurred, sharp);
        // The planted error: the lens's diameter taken for its radius.
        figure("LENS-COC", GetParam(),
               fmt::format("z = {}: {:.2f} pixels, found {:.2f}", z, truth, found),
               std::fabs(found - truth), 0.5,
               z == focus ? std::nullopt : std::optional(std::fabs(found - 2 * truth)));
        const Estimate a = estimate(blurred), b = estimate(sharp);
        const double energy = 100 * emitter * emitter / (side * side); // radiance times its share
        figure("LENS-COC", GetParam(), fmt::format("z = {}: light, lens", z),
               std::fabs(a.mean / energy - 1), 1e-4 + 4 * a.error / energy);
        figure("LENS-COC", GetParam(), fmt::format("z = {}: light, pinhole", z),
               std::fabs(b.mean / energy - 1), 1e-4 + 4 * b.error / energy);
    }
}

// A lens without size is a pinhole, bit for bit, wherever it is focused.
TEST_P(EachLab, LensCocALensOfRadiusZeroIsAPinhole) {
    Scene scene = load_scene(find_scene("depth_of_field"));
    set_film_size(scene.camera, 32, 20);
    const Film with_lens = trace(GetParam(), scene, 2).film;
    scene.camera.lens_radius = 0;
    const Film film = trace(GetParam(), scene, 2).film;
    scene.camera.focus_distance = 0.37f;
    EXPECT_TRUE(same_bits(trace(GetParam(), scene, 2).film, film));
    EXPECT_FALSE(same_bits(with_lens, film));
}

// A lens of next to no size is next to a pinhole, wherever the scene lies: half of the view is a
// wall that glows. Far from the origin, a ray's direction that is computed as a difference of two
// positions has lost its digits: pixels are off by .013 in the mean at 2^20.
TEST_P(EachLab, LensCocATinyLensIsAPinholeFarFromTheOrigin) {
    for (const double x : {0.0, 0x1p16, 0x1p20}) {
        const auto film = [&](const std::string& lens) {
            return trace(GetParam(),
                         parse({.camera = camera({x, 0, 0}, {x, 0, -2}, 60, lens),
                                .materials = R"("light": )" + diffuse(DVec3(0), DVec3(1)),
                                .shapes = quad({x, -1024, -1024}, {x + 1024, -1024, -1024},
                                               {x + 1024, 1024, -1024}, {x, 1024, -1024}, "light"),
                                .render = R"("max_depth": 1, "sampler": "independent")",
                                .width = 32,
                                .height = 32}),
                         16)
                .film;
        };
        const Film pinhole = film(""), tiny = film(R"(, "lens_radius": 1e-6, "focus_distance": 2)");
        double differ = 0;
        for (std::size_t i = 0; i < tiny.pixels.size(); ++i)
            differ += std::fabs(pixel_mean(tiny.pixels[i]) - pixel_mean(pinhole.pixels[i])) /
                      static_cast<double>(tiny.pixels.size());
        figure("LENS-COC", GetParam(), fmt::format("lens of 1e-6 at x = {}: mean |difference|", x),
               differ, 1e-4);
        EXPECT_NEAR(estimate(pinhole).mean, 0.5, 0.01);
    }
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
