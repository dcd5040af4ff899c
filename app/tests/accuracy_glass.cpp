// PANE, GLASS-FURN, GLASS-FLOOR: glass neither adds nor removes light, and lets no light through a
// surface that it touches.
#include "app/tests/accuracy.h"

namespace raylab::app {

namespace {

// --- PANE -------------------------------------------------------------------------------------

// Fresnel for unpolarised light from air into index n.
double fresnel(double cosine, double n) {
    const double cos_t = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
    const double s = (cosine - n * cos_t) / (cosine + n * cos_t);
    const double p = (n * cosine - cos_t) / (n * cosine + cos_t);
    return (s * s + p * p) / 2;
}

// A pane of thickness 1e-4 S before an even light that fills what shines through.
Scene pane(double size, double angle_deg, const std::string& more, const std::string& render) {
    const std::string turned = fmt::format(
        R"(, "transform": {{"rotate": [{{"axis": [0, 1, 0], "angle_deg": {}}}]}})", angle_deg);
    return parse({.camera = camera({0, 0, 10 * size}, {0, 0, 0}, 0.01),
                  .materials = R"("pane": {"kind": "glass", "ior": 1.5)" + more +
                               R"(}, "light": )" + diffuse(DVec3(0), DVec3(1)),
                  .shapes = box(size * DVec3(-0.2, -0.2, -5e-5), size * DVec3(0.2, 0.2, 5e-5),
                                "pane", turned) +
                            ", " +
                            quad(size * DVec3(-1, -1, -2), size * DVec3(1, -1, -2),
                                 size * DVec3(1, 1, -2), size * DVec3(-1, 1, -2), "light"),
                  .render = render,
                  .width = 64,
                  .height = 64});
}

// All reflections inside add up to T = (1 - R) / (1 + R): 0.92307692 and 0.83623246.
TEST_P(EachLab, PaneTransmitsWhatFresnelLeaves) {
    const std::string whitted = R"("integrator": "whitted", "max_depth": 20)";
    const std::string path = R"("max_depth": 24, "roulette": false, "sampler": "independent")";
    for (const double angle : {0.0, 60.0}) {
        const double r = fresnel(std::cos(glm::radians(angle)), 1.5), truth = (1 - r) / (1 + r);
        for (const double size : {1e-2, 1.0, 1e4}) {
            // Whitted's tracer follows both ways at every interface: no noise.
            const auto off = [&](const std::string& more) {
                return std::fabs(
                    estimate(trace(GetParam(), pane(size, angle, more, whitted), 2).film).mean -
                    truth);
            };
            figure("PANE", GetParam(), fmt::format("{} deg, S = {}, whitted", angle, size), off(""),
                   2e-5,
                   angle > 0 ? std::optional(off(R"(, "fresnel": "schlick")")) : std::nullopt);
            const Estimate found =
                estimate(trace(GetParam(), pane(size, angle, "", path), count(8, 256)).film);
            figure("PANE", GetParam(),
                   fmt::format("{} deg, S = {}, path: {:.5f}", angle, size, found.mean),
                   std::fabs(found.mean - truth), 1e-4 + 4 * found.error);
        }
    }
    EXPECT_NEAR(fresnel(0.5, 1.5), 0.0891867128, 1e-9);
}

// --- GLASS-FURN -------------------------------------------------------------------------------

// In an even white world every path that gets out finds 1, with weight 1: each pixel's sum is the
// number of its paths that were not cut off at max_depth.
TEST_P(EachLab, GlassFurnEveryPathThatGetsOutFindsOne) {
    for (const double size : {1e-3, 1.0, 1e4}) {
        Scene scene = parse({.camera = camera(size * DVec3(0, 0.3, 5), {0, 0, 0}, 40),
                             .materials = R"("glass": {"kind": "glass", "ior": 1.5},
                             "bubble": {"kind": "glass", "ior": 0.6666666666666667})",
                             .shapes = sphere(size * DVec3(-1.1, 0, 0), size, "glass") + ", " +
                                       sphere(size * DVec3(1.1, 0, 0), size, "glass") + ", " +
                                       sphere(size * DVec3(1.1, 0, 0), 0.6 * size, "bubble"),
                             .lights = white_sky,
                             .render = R"("max_depth": 64, "roulette": false)",
                             .width = 32,
                             .height = 20});
        const auto worst = [&](const Traced& traced) {
            const std::size_t pixels = traced.film.pixels.size();
            double off = 0;
            for (std::size_t i = 0; i < pixels; ++i) {
                double out = 0;
                for (std::size_t k = i; k < traced.records.size(); k += pixels)
                    out += traced.records[k].end == PathEnd::escaped;
                off = std::max(off,
                               std::fabs(traced.film.pixels[i].sum[0] - out) / std::max(1.0, out));
            }
            return off;
        };
        const Traced traced = trace(GetParam(), scene, count(16, 1024));
        const double tail = paths_that(traced, PathEnd::depth) * 1.0 / traced.records.size();
        scene.materials[0].reflectance = Vec3(0.9999f); // the planted error
        figure("GLASS-FURN", GetParam(), fmt::format("S = {}: worst pixel", size), worst(traced),
               1e-5, worst(trace(GetParam(), scene, 4)));
        figure("GLASS-FURN", GetParam(), fmt::format("S = {}: paths beyond 64 surfaces", size),
               tail, 1e-5);
        EXPECT_EQ(paths_that(traced, PathEnd::absorbed), 0);
    }
}

// --- GLASS-FLOOR ------------------------------------------------------------------------------

// A glass box on a black floor, a lamp below it. Box and floor are in one plane where they touch,
// and no light may pass the floor there, wherever the box stands in the file: at equal t an opaque
// surface counts before glass.
TEST_P(EachLab, GlassOnAFloorLetsNothingThroughTheFloor) {
    const std::string block = box({-1, 0, -1}, {1, 0.7, 1}, "glass");
    const std::string floor = quad({-9, 0, -9}, {-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, "floor");
    const std::string lamp = quad({-9, -1, -9}, {9, -1, -9}, {9, -1, 9}, {-9, -1, 9}, "lamp");
    const auto lit_pixels = [&](const std::string& shapes, const std::string& integrator) {
        const Scene scene =
            parse({.camera = camera({0.3, 3, 2}, {0, 0, 0}, 40),
                   .materials = R"("glass": {"kind": "glass", "ior": 1.5}, )"
                                R"("floor": )" +
                                diffuse(DVec3(0)) + R"(, "lamp": )" + diffuse(DVec3(0), DVec3(1)),
                   .shapes = shapes,
                   .render = R"("max_depth": 9, "integrator": ")" + integrator + "\"",
                   .width = 32,
                   .height = 32});
        const Film film = trace(GetParam(), scene, count(4, 100)).film;
        return static_cast<double>(
            std::count_if(film.pixels.begin(), film.pixels.end(),
                          [](const FilmPixel& pixel) { return pixel.sum[0] != 0; }));
    };
    for (const std::string integrator : {"path", "whitted"}) {
        figure("GLASS-FLOOR", GetParam(), integrator + ", block first: lit pixels",
               lit_pixels(block + ", " + floor + ", " + lamp, integrator), 0);
        figure("GLASS-FLOOR", GetParam(), integrator + ", floor first: lit pixels",
               lit_pixels(floor + ", " + block + ", " + lamp, integrator), 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
