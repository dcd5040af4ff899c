// Planes: rays along them, rays that graze them, origins on them.
#include "common/geometry/tests/naive.h"
#include "common/geometry/tests/support.h"

namespace raylab::test {
namespace {

TEST(PLANE_GRAZE, a_grazing_ray_misses_or_hits_at_h_over_cos) {
    const Plane ground{Vec3(7, 0, -3), Vec3(0, 1, 0), {}};
    double worst = 0;
    int bad = 0, naive_bad = 0;
    for (float slope : {0.0f, -0.0f, 1e-38f, -1e-38f, 1e-8f, -1e-8f, 1e-4f, -1e-4f, -1.0f})
        for (float h : {0.0f, -0.0f, 1e-30f, -1e-30f, 1e-6f, -1e-6f, 1.0f, -1.0f, 1e6f, -1e6f}) {
            const Ray ray{Vec3(2, h, 5), Vec3(sqrtf(1 - slope * slope), slope, 0)};
            const Real exact = slope == 0 ? Real(-1) : -Real(h) / Real(slope);
            const bool is_hit = exact > 0 && exact <= Real(std::numeric_limits<float>::max());
            float t = -1;
            const bool found = intersect(ground, ray, t);
            bad += found != is_hit || (found && !std::isfinite(t));
            if (found && is_hit) worst = std::max(worst, double(fabsl(t - exact) / exact));
            float naive_t = -1;
            naive_bad += naive::plane(ground, ray, naive_t) != is_hit;
        }
    figure("PLANE-GRAZE", "wrong answers, axis-aligned", bad, 0, naive_bad);
    figure("PLANE-GRAZE", "t, axis-aligned", worst, 1e-6);
}

// A tilted plane: n.d is a small difference of products, which float does not hold.
TEST(PLANE_GRAZE, tilted_planes_keep_their_digits_at_grazing_angles) {
    Random random(5);
    double worst = 0, naive_worst = 0;
    int wrong = 0;
    for (int i = 0; i < rays(50'000, 1'000'000); ++i) {
        const Plane plane{random.direction(), random.direction(), {}};
        const DVec3 n(plane.normal), side = glm::normalize(cross(n, random.unit()));
        const Vec3 o(DVec3(plane.point) + random.between(-3, 3) * side + random.between(-1, 1) * n);
        const double slope = std::pow(10, random.between(-5, 0)) * (random.below(2) ? 1 : -1);
        const Ray ray{o, Vec3(glm::normalize(side + slope * n))};
        const Real exact = dot(RVec(n), RVec(plane.point) - RVec(o)) / dot(RVec(n), RVec(ray.d));
        float t;
        const bool found = intersect(plane, ray, t);
        wrong += found != (exact > 0);
        if (!found || exact <= 0) continue;
        worst = std::max(worst, double(fabsl(t - exact) / exact));
        if (naive::plane(plane, ray, t))
            naive_worst = std::max(naive_worst, double(fabsl(t - exact) / exact));
    }
    figure("PLANE-GRAZE", "wrong side, tilted", wrong, 0);
    figure("PLANE-GRAZE", "t, tilted, cos from 1e-5", worst, 1e-6, naive_worst);
}

} // namespace
} // namespace raylab::test
