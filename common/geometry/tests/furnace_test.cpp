// FURN-CHORD: in a closed diffuse sphere the mean distance from hit to hit is 4 R / 3.
//
// Radiance in a furnace does not change when a ray finds its own surface again at once; the mean
// chord does. With the cosine law p(theta) = 2 sin cos and chord 2 R cos(theta) it is 4 R / 3, and
// each chord is known from the direction at which it started.
#include "common/geometry/tests/naive.h"
#include "common/geometry/tests/support.h"

namespace raylab::test {
namespace {

TEST(FURN_CHORD, the_mean_chord_of_a_closed_sphere_is_four_thirds_of_its_radius) {
    const int n = rays(100'000, 1'000'000);
    for (double r : {1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6}) {
        Random random(120);
        World world;
        world.add(Sphere{Vec3(r * DVec3(0.3, -0.2, 0.5)), float(r), {}});
        const SceneView scene = world.view();
        const Sphere& sphere = world.spheres[0];

        Ray ray{sphere.center, random.direction()};
        double sum = 0, sum2 = 0, expected = r;
        int self_hits = 0, escapes = 0;
        for (int i = -1; i < n; ++i) {
            const Hit hit = intersect<feature::sphere>(scene, ray);
            if (!hit.found()) {
                ++escapes;
                break;
            }
            if (i >= 0) {
                sum += hit.t, sum2 += double(hit.t) * hit.t;
                self_hits += hit.t < 0.5 * expected && expected > 1e-3 * r;
            }
            const SurfacePoint p = surface_at<feature::sphere>(scene, ray, hit);
            const Vec3 w = random.cosine_direction(-p.ng);
            expected = -2 * r * dot(DVec3(w), DVec3(p.ng));
            ray = spawn_ray(p, w);
        }
        const double mean = sum / n, error = sqrt((sum2 / n - mean * mean) / n);

        // The hit point as o + t d, and everything nearer than 1e-4 ignored.
        Ray naive_ray{sphere.center, random.direction()};
        double naive_sum = 0;
        const int naive_n = n / 10;
        for (int i = -1; i < naive_n; ++i) {
            float t;
            if (!naive::sphere(sphere, naive_ray, 1e-4f, t)) {
                naive_ray = {sphere.center, random.direction()}; // lost: a chord of 0
                continue;
            }
            if (i >= 0) naive_sum += t;
            const Vec3 p = naive_ray(t);
            naive_ray = {p, random.cosine_direction(normalize(Vec3(sphere.center) - p))};
        }
        char at[32];
        std::snprintf(at, sizeof at, ", R = %g", r);
        const bool fails = r > 1e3 || r < 1e-3;
        const double truth = 4 * double(sphere.radius) / 3;
        figure("FURN-CHORD", std::string("mean chord against 4 R / 3") + at, fabs(mean / truth - 1),
               1e-3 + 4 * error / truth,
               fails ? std::optional(fabs(naive_sum / naive_n / truth - 1)) : std::nullopt);
        figure("FURN-CHORD", std::string("self hits per 1e6") + at, 1e6 * self_hits / n, 1);
        figure("FURN-CHORD", std::string("escapes") + at, escapes, 0);
    }
}

} // namespace
} // namespace raylab::test
