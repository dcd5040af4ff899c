// LENS-COC: out of focus, a point becomes a disc of the lens's shape, and keeps its light.
//
// With aperture (diameter) A and focus distance f, a point at distance z blurs to a disc of diameter
// A |z - f| / z on the plane in focus. PBR4e 5.2.3.
#include "app/tests/accuracy.h"

namespace raylab::app {

namespace {

constexpr int side = 64;
constexpr double vfov = 40, focus = 2, aperture = 0.5;

// A small glowing square at distance z: seen from any point of the lens it has the same size.
constexpr double emitter = 0.02;

Scene point_at(double z, double lens_radius, double focus_distance) {
    const double s = emitter / 2;
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

// Diameter of a uniform disc with this image's second moment: a disc of radius R has E[r^2] = R^2/2.
// The emitter's own s^2 / 6 and the pixels' 1/6 are taken off.
double diameter(const Film& film, double pixels_per_emitter) {
    double sum = 0, second = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double value = film.pixels[y * side + x].sum[0];
            const double dx = x + 0.5 - side / 2, dy = y + 0.5 - side / 2;
            sum += value;
            second += value * (dx * dx + dy * dy);
        }
    const double spread = second / sum - (1 + pixels_per_emitter * pixels_per_emitter) / 6;
    return 2 * std::sqrt(2 * std::max(0.0, spread));
}

TEST_P(EachLab, LensCocDiscHasTheLensesDiameterAndKeepsItsLight) {
    const double pixels_per_unit = side / (2 * std::tan(glm::radians(vfov / 2))); // at distance 1
    for (const double z : {1.2, 1.5, 2.0, 3.0, 8.0}) {
        const int spp = count(400, 6400);
        const Film blurred = trace(GetParam(), point_at(z, aperture / 2, focus), spp).film;
        const Film sharp = trace(GetParam(), point_at(z, 0, focus), spp).film;
        // On the film, the disc is as wide as seen from the lens's middle on the plane in focus.
        const double truth = aperture * std::fabs(z - focus) / z / focus * pixels_per_unit;
        const double size = emitter / z * pixels_per_unit;
        figure("LENS-COC", GetParam(),
               fmt::format("z = {}: {:.2f} pixels, found {:.2f}", z, truth, diameter(blurred, size)),
               std::fabs(diameter(blurred, size) - truth), 0.5,
               z == focus ? std::nullopt : std::optional(std::fabs(diameter(sharp, size) - truth)));
        const Estimate a = estimate(blurred), b = estimate(sharp);
        const double energy = 100 * size * size / (side * side); // L (s / z)^2 over the film
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

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
