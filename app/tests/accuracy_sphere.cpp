// SPH-TINY, SPH-INSIDE, SPH-HUGE, for each lab's own sphere. Truth in long double (64 bits).
#include "app/tests/accuracy.h"

namespace raylab::app {

namespace {

using Real = long double;
using RVec = glm::vec<3, Real>;

bool hit_sphere(const std::string& lab, const Sphere& sphere, const Ray& ray, float& t) {
    return lab == "01" ? lab01::hit_sphere(sphere, ray, t) : intersect(sphere, ray, t);
}

// smallpt's test (Beason 2007) in float: the naive variant.
bool smallpt(const Sphere& sphere, const Ray& ray, float& t) {
    const Vec3 op = Vec3(sphere.center) - ray.o;
    const float b = dot(op, ray.d), r = static_cast<float>(sphere.radius);
    const float det = b * b - dot(op, op) + r * r;
    if (det < 0) return false;
    t = b - sqrtf(det) > 0 ? b - sqrtf(det) : b + sqrtf(det);
    return t > 0;
}

// The discriminant over a^2 and the near root.
bool exactly(const Sphere& sphere, const Ray& ray, Real& t) {
    const RVec f = RVec(ray.o) - RVec(sphere.center), d(ray.d);
    const Real a = dot(d, d), b = -dot(f, d);
    const RVec nearest = f + (b / a) * d;
    const Real disc = Real(sphere.radius) * sphere.radius - dot(nearest, nearest);
    if (disc < 0) return false;
    t = b / a - std::sqrt(disc / a);
    return true;
}

TEST_P(EachLab, SphTinyFewFalseMissesAndHits) {
    for (const double ratio : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6}) {
        test::Random random(71);
        const int rays = count(20'000, 1'000'000);
        int wrong = 0, naive_wrong = 0;
        std::vector<double> off;
        for (int i = 0; i < rays; ++i) {
            const Sphere s = {random.direction(), static_cast<float>(ratio), {0, 0, -1}};
            const DVec3 c(s.center);
            const DVec3 across = glm::normalize(cross(c, DVec3(random.direction())));
            const Ray ray = {Vec3(0), Vec3(glm::normalize(c + 1.25 * ratio * random.u() * across))};
            Real truth = 0;
            float t = 0, naive_t = 0;
            const bool hits = exactly(s, ray, truth), found = hit_sphere(GetParam(), s, ray, t);
            wrong += hits != found;
            naive_wrong += hits != smallpt(s, ray, naive_t);
            if (hits && found) off.push_back(std::fabs(static_cast<double>(t / truth - 1)));
        }
        std::sort(off.begin(), off.end());
        const double percent = 100.0 / rays;
        figure("SPH-TINY", GetParam(), fmt::format("r/D = {}: wrong, %", ratio), wrong * percent,
               ratio >= 1e-4 ? 0.05 : 3,
               ratio <= 1e-3 ? std::optional(naive_wrong * percent) : std::nullopt);
        figure("SPH-TINY", GetParam(), fmt::format("r/D = {}: t, 99.9th percentile", ratio),
               off[off.size() * 999 / 1000], 1e-6);
    }
}

TEST_P(EachLab, SphInsideAlwaysHits) {
    test::Random random(72);
    int misses = 0;
    double residue = 0;
    for (int i = 0; i < count(50'000, 1'000'000); ++i) {
        const float r = std::ldexp(1.0f, static_cast<int>(random.between(-10, 10)));
        const Sphere s = {r * random.direction(), r, {0, 0, -1}};
        const Vec3 o = Vec3(s.center) + random.between(0, 0.999f) * r * random.direction();
        const Ray ray = {o, random.direction()};
        float t = 0;
        if (!hit_sphere(GetParam(), s, ray, t)) {
            ++misses;
            continue;
        }
        const RVec p = RVec(o) + Real(t) * RVec(ray.d) - RVec(s.center);
        residue = std::max(residue, std::fabs(static_cast<double>(std::sqrt(dot(p, p)) / r - 1)));
    }
    figure("SPH-INSIDE", GetParam(), "misses", misses, 0);
    figure("SPH-INSIDE", GetParam(), "distance from the surface / r", residue, 4e-7);
}

// A ground sphere seen from 1 above it, and the plane that the loader puts in its place when it is
// too large even for double. The naive variant is the sphere by smallpt.
TEST_P(EachLab, SphHugeIsRight) {
    for (const double ratio : {1e3, 1e5, 1e7, 1e9, 1e12}) {
        const Scene scene = parse({.camera = camera({0, 1, 0}, {1, 0, 0}, 40),
                                   .materials = R"("m": )" + diffuse(DVec3(0.5)),
                                   .shapes = sphere({0, -ratio, 0}, ratio, "m")});
        ASSERT_EQ(scene.planes.size(), ratio > 1e11 ? 1u : 0u);
        const SceneView v = view(scene);
        const Sphere ground = {DVec3(0, -ratio, 0), ratio, {}};
        test::Random random(73);
        std::vector<double> smallpt_off;
        double largest = 0;
        for (int i = 0; i < count(5000, 100'000); ++i) {
            const float slope = random.between(0.05f, 1), phi = random.between(0, 2 * pi);
            const Ray ray = {Vec3(0, 1, 0), normalize(Vec3(std::cos(phi), -slope, std::sin(phi)))};
            const Hit hit = closest(GetParam(), v, ray);
            Real truth = -1 / Real(ray.d.y);
            if (scene.planes.empty()) {
                ASSERT_TRUE(exactly(ground, ray, truth));
            }
            largest = std::max(largest, std::fabs(static_cast<double>(hit.t / truth - 1)));
            float t = infinity;
            smallpt(ground, ray, t);
            smallpt_off.push_back(std::fabs(static_cast<double>(t / truth - 1)));
        }
        std::sort(smallpt_off.begin(), smallpt_off.end());
        figure("SPH-HUGE", GetParam(), fmt::format("r/h = {}: t", ratio), largest, 1e-6,
               smallpt_off[smallpt_off.size() / 2]);
    }
}

// The center and the radius as they are written. The naive variant: rounded to single precision,
// they put the surface a tenth of its distance too low.
TEST_P(EachLab, SphHugeLiesWhereItIsWritten) {
    const double r = 7.3e6 + 0.2, height = 2, truth = height + 0.3;
    Scene scene = parse({.camera = camera({0, height, 0}, {1, 0, 0}, 40),
                         .materials = R"("m": )" + diffuse(DVec3(0.5)),
                         .shapes = sphere({0, -r - 0.3, 0}, r, "m")});
    ASSERT_EQ(scene.spheres.size(), 1u);
    const auto off = [&] {
        const Ray down = {Vec3(0, height, 0), Vec3(0, -1, 0)};
        return std::fabs(closest(GetParam(), view(scene), down).t / truth - 1);
    };
    const double ours = off();
    scene.spheres[0].center = Vec3(scene.spheres[0].center);
    scene.spheres[0].radius = static_cast<float>(scene.spheres[0].radius);
    scene.sphere_groups = group_spheres(scene.spheres);
    figure("SPH-HUGE", GetParam(), "r = 7.3e6: t straight down", ours, 1e-7, off());
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
