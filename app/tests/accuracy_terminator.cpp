// SHADOW-TERM: where smooth shading meets flat shadows.
//
// A coarse mesh with a sphere's normals, lit from the side: interpolated normals fade slowly, but a
// face that turns away from the light is cut off at once. Hanika, Hacking the Shadow Terminator,
// Ray Tracing Gems II ch. 4: lifting the shadow ray's origin onto the curved surface would let the
// interpolated normal decide alone. raylab does not lift; the test reports both errors.
#include "app/tests/accuracy.h"
#include "app/tests/icosphere.h"
#include "common/trace/surface.h"

namespace raylab::app {

namespace {

constexpr int side = 48;

// Camera and light stand at right angles, turned about y so that no edges of the mesh lie along the
// terminator.
const double turn = glm::radians(17.0);
const DVec3 to_light(std::cos(turn), 0, -std::sin(turn)),
    to_camera(std::sin(turn), 0, std::cos(turn));

// The unit sphere of 80 triangles, irradiance pi from far away: radiance is n.l.
Scene lit_from_the_side() {
    Scene scene =
        parse({.camera = camera(50.0 * to_camera, {0, 0, 0}, 2 * std::atan(0.55 / 49) * 180 / M_PI),
               .materials = R"("white": )" + diffuse(DVec3(1)),
               .shapes = "",
               .lights = fmt::format(R"({{"kind": "point", "position": {}, "intensity": {}}})",
                                     text(1e4 * to_light), text(DVec3(M_PI * 1e8))),
               .render = R"("max_depth": 2)",
               .width = side,
               .height = side});
    add_icosphere(scene, 1, 1, 0, true);
    return scene;
}

TEST_P(EachLab, ShadowTermIsNeverNegativeAndFallsTowardsTheDark) {
    const Scene scene = lit_from_the_side();
    const SceneView v = view(scene);
    const Film film = trace(GetParam(), scene, count(16, 256)).film;
    double without_lift = 0, with_lift = 0, steps_up = 0;
    for (int y = 0; y < side; ++y) {
        double brightest = 0;
        for (int x = 0; x < side; ++x) { // from the dark side to the light
            const Ray ray = generate_ray(v.camera, x, y, Vec2(0.5f), Vec2(0.5f));
            // The analytic sphere at the pixel's middle: n is the point itself.
            const DVec3 o(ray.o), d(ray.d);
            const double b = dot(o, d), t = -b - std::sqrt(b * b - dot(o, o) + 1);
            const double truth = std::max(0.0, dot(o + t * d, to_light));
            const Hit hit = closest(GetParam(), v, ray);
            ASSERT_TRUE(hit.found());
            const double normal =
                dot(DVec3(surface_at<feature::all>(v, ray, hit).shading.z), to_light);
            const double value = pixel_mean(film.pixels[y * side + x]);
            EXPECT_GE(value, 0);
            without_lift = std::max(without_lift, std::fabs(value - truth));
            with_lift = std::max(with_lift, std::fabs(std::max(0.0, normal) - truth));
            steps_up = std::max(steps_up, brightest - value);
            brightest = std::max(brightest, value);
        }
    }
    note("SHADOW-TERM", GetParam(), "largest error without lift", without_lift);
    note("SHADOW-TERM", GetParam(), "largest error if shadow rays were lifted", with_lift);
    figure("SHADOW-TERM", GetParam(), "largest fall towards the light", steps_up, 0.01);
    EXPECT_LT(with_lift, without_lift);
    EXPECT_LT(without_lift, 0.35); // a face of 80 leans at most 20 degrees from its sphere: sin
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
