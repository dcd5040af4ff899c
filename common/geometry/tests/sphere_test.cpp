// Spheres that are tiny, huge, grazed, or around the ray's origin.
#include "common/geometry/tests/naive.h"
#include "common/geometry/tests/support.h"

#include <algorithm>

namespace raylab::test {
namespace {

Real length(const RVec& v) { return sqrtl(dot(v, v)); }

// The exact intersection of the ray as given in float, d of any length.
struct Truth {
    Real impact;        // distance of the line from the centre
    Real near_t, far_t; // NaN if the line misses

    Truth(const Sphere& sphere, const Ray& ray) {
        const RVec f = RVec(ray.o) - RVec(sphere.center), d(ray.d);
        const Real middle = -dot(f, d) / dot(d, d);
        impact = length(f + middle * d);
        const Real half =
            sqrtl((Real(sphere.radius) * sphere.radius - impact * impact) / dot(d, d));
        near_t = middle - half;
        far_t = middle + half;
    }
};

// A ray from a distance D whose line passes the centre at about `impact`.
Ray aim(Random& random, const Sphere& sphere, double D, double impact) {
    const DVec3 to = random.unit();
    const DVec3 side = glm::normalize(cross(to, random.unit()));
    const Vec3 o(DVec3(sphere.center) - D * to);
    return {o, Vec3(glm::normalize(DVec3(sphere.center) + impact * side - DVec3(o)))};
}

double quantile(std::vector<double>& errors, double q) {
    const auto at = errors.begin() + std::min(size_t(q * errors.size()), errors.size() - 1);
    std::nth_element(errors.begin(), at, errors.end());
    return *at;
}

TEST(SPH_TINY, few_false_misses_and_hits_and_t_right_to_one_part_in_a_million) {
    const double D = 100;
    const int n = rays(40'000, 1'000'000);
    for (int k = 1; k <= 8; ++k) { // 7 and 8: beyond float, and beyond the textbook in double
        Random random(k);
        const Sphere sphere{Vec3(3, -2, 5), float(D * pow(10, -k)), {}};
        int hits = 0, misses = 0, false_miss = 0, false_hit = 0, naive_miss = 0;
        std::vector<double> errors, naive_errors;
        for (int i = 0; i < n; ++i) {
            const Ray ray = aim(random, sphere, D, random.between(0, 1.25) * sphere.radius);
            const Truth truth(sphere, ray);
            const bool is_hit = truth.impact <= sphere.radius;
            (is_hit ? hits : misses)++;
            float t;
            const bool found = intersect(sphere, ray, t);
            false_miss += is_hit && !found;
            false_hit += !is_hit && found;
            if (is_hit && found) errors.push_back(double(fabsl(t - truth.near_t) / truth.near_t));
            const bool naive_found = naive::sphere(sphere, ray, 0, t);
            naive_miss += is_hit && !naive_found;
            if (is_hit && naive_found)
                naive_errors.push_back(double(fabsl(t - truth.near_t) / truth.near_t));
        }
        const std::string at = " r/D = 1e-" + std::to_string(k);
        const double tolerance = k == 5 || k == 6 ? 3 : 0.05;
        const auto naive = [&](double x) { return k >= 3 ? std::optional(x) : std::nullopt; };
        figure("SPH-TINY", "false misses in %," + at, 100.0 * false_miss / hits, tolerance,
               naive(100.0 * naive_miss / hits));
        figure("SPH-TINY", "false hits in %," + at, 100.0 * false_hit / misses, tolerance);
        figure("SPH-TINY", "t, 99.9 % of relative errors," + at, quantile(errors, 0.999), 1e-6,
               naive(quantile(naive_errors, 0.999)));
    }
}

// A ground sphere of radius r seen from h above it: in double it is right as long as r / h is far
// from 2^52. Beyond 2^30 the loader puts a plane in its place.
TEST(SPH_HUGE, a_ground_sphere_is_as_right_as_a_plane) {
    const int n = rays(10'000, 1'000'000);
    for (int k = 3; k <= 9; ++k) {
        Random random(k);
        const float h = 1, r = float(pow(10, k));
        const Sphere ground{Vec3(0, -r, 0), r, {}};
        const Plane plane{Vec3(0), Vec3(0, 1, 0), {}};
        std::vector<double> plane_errors, sphere_errors, naive_errors;
        int shot = 0, false_hits = 0, naive_false_hits = 0;
        for (int i = 0; i < n; ++i) {
            const Ray down{Vec3(0, h, 0),
                           Vec3(glm::normalize(DVec3(1, -random.between(0.01, 1), 0)))};
            const Ray up{down.o, Vec3(down.d.x, -down.d.y, 0)};
            const Truth truth(ground, down);
            if (std::isnan(truth.near_t)) continue; // beyond the sphere's own horizon
            ++shot;
            float t;
            if (intersect(plane, down, t)) {
                const Real exact = Real(h) / -Real(down.d.y);
                plane_errors.push_back(double(fabsl(t - exact) / exact));
            }
            // A missed ground counts as an error of 1.
            sphere_errors.push_back(
                intersect(ground, down, t) ? double(fabsl(t - truth.near_t) / truth.near_t) : 1);
            naive_errors.push_back(naive::sphere(ground, down, 0, t)
                                       ? double(fabsl(t - truth.near_t) / truth.near_t)
                                       : 1);
            false_hits += intersect(plane, up, t) || intersect(ground, up, t);
            naive_false_hits += naive::sphere(ground, up, 0, t);
        }
        ASSERT_EQ(int(plane_errors.size()), shot);
        const std::string at = " r/h = 1e" + std::to_string(k);
        figure("SPH-HUGE", "t of the plane," + at, quantile(plane_errors, 1), 1e-6,
               quantile(naive_errors, 0.999));
        figure("SPH-HUGE", "t of the sphere," + at, quantile(sphere_errors, 1), 1e-6,
               quantile(naive_errors, 0.999));
        figure("SPH-HUGE", "false hits above the horizon in %," + at, 100.0 * false_hits / shot, 0,
               k >= 8 ? std::optional(100.0 * naive_false_hits / shot) : std::nullopt);
    }
}

TEST(SPH_TANGENT, wrong_only_within_the_error_of_one_dot_product) {
    const int n = rays(5'000, 200'000);
    int wrong = 0, naive_wrong = 0, nan = 0;
    Random random(1);
    for (int k = 4; k <= 22; ++k)
        for (int sign : {-1, 1})
            for (int i = 0; i < n / 19; ++i) {
                const double r = 1, D = random.between(1.5, 100);
                const Sphere sphere{random.direction(), float(r), {}};
                const Ray ray = aim(random, sphere, D, r * (1 + sign * std::ldexp(1.0, -k)));
                const Truth truth(sphere, ray);
                if (fabsl(truth.impact / r - 1) <= 4 * 0x1p-24 * D / r) continue;
                const bool is_hit = truth.impact < r;
                float t = 0;
                wrong += intersect(sphere, ray, t) != is_hit;
                nan += std::isnan(t);
                naive_wrong += naive::sphere(sphere, ray, 0, t) != is_hit;
            }
    figure("SPH-TANGENT", "wrong outside 4 u D / r", wrong, 0, naive_wrong);
    figure("SPH-TANGENT", "NaN", nan, 0);
}

TEST(SPH_INSIDE, a_ray_from_inside_always_hits) {
    const int n = rays(50'000, 1'000'000);
    for (float r : {1e-4f, 1.0f, 1e6f}) {
        Random random(3);
        int misses = 0, naive_misses = 0;
        double residue = 0;
        for (int i = 0; i < n; ++i) {
            const Sphere sphere{r * random.direction(), r, {}};
            const double depth = i % 4 ? random.between(0, 0.999) : 0.999;
            const Ray ray{Vec3(DVec3(sphere.center) + depth * r * random.unit()),
                          random.direction()};
            float t;
            if (intersect(sphere, ray, t)) {
                const RVec at = RVec(ray.o) + Real(t) * RVec(ray.d);
                const Real off = fabsl(length(at - RVec(sphere.center)) - r) / r;
                residue = std::max(residue, double(off));
            } else {
                ++misses;
            }
            naive_misses += !naive::sphere(sphere, ray, 1e-4f, t);
        }
        char at[32];
        std::snprintf(at, sizeof at, ", r = %g", r);
        figure("SPH-INSIDE", std::string("misses") + at, misses, 0,
               r < 1e-3f ? std::optional<double>(naive_misses) : std::nullopt);
        figure("SPH-INSIDE", std::string("distance of o + t d from the sphere / r") + at, residue,
               4e-7);
    }
}

} // namespace
} // namespace raylab::test
