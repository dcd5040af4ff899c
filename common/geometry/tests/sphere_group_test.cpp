// The glance at sixteen spheres: what it drops is missed.
#include "common/geometry/tests/support.h"

#include <gtest/gtest.h>

namespace raylab {
namespace {

using namespace test;

// A sphere of a random size, and as far from the origin as the size of 2^12 of it.
Sphere random_sphere(Random& random, double scale) {
    const double radius = scale * std::ldexp(1 + random.uniform(), random.below(16));
    const DVec3 at = radius * random.unit() * std::ldexp(1, int(12 * random.uniform()));
    Sphere sphere{};
    sphere.center = Vec3(at);
    sphere.radius = float(radius);
    return sphere;
}

// A ray past the sphere's rim, a little inside or outside of it, or anywhere through it; from close
// by, from far away or from inside, towards it or away from it.
Ray random_ray(Random& random, const Sphere& sphere, int k) {
    const double r = sphere.radius;
    const DVec3 d = random.unit(), side = glm::normalize(cross(d, random.unit()));
    const double past =
        k % 3 == 0 ? random.uniform() : 1 + std::ldexp(random.uniform() - 0.5, -random.below(30));
    const double back = r * std::ldexp(random.uniform(), int(20 * random.uniform()) - 8);
    const DVec3 o = DVec3(sphere.center) + r * past * side - back * d;
    return {Vec3(o), normalize(Vec3(k % 5 == 1 ? -d : d)), k % 7 == 3 ? float(back) : infinity};
}

// What a glance without a margin would say.
bool naive_hit(const SphereGroup& group, int lane, const Ray& ray) {
    const Vec3 f =
        ray.o - Vec3(group.center[0][lane], group.center[1][lane], group.center[2][lane]);
    const float middle = -dot(f, ray.d), r = group.radius[lane];
    const Vec3 nearest = f + middle * ray.d;
    return dot(nearest, nearest) <= r * r && middle + r >= 0 && middle - r <= ray.t_max;
}

TEST(SphereGlance, loses_no_hit) {
    Random random(19);
    long hits = 0, lost = 0, kept = 0, naive_lost = 0, lanes = 0;
    const int groups = rays(4000, 400000);
    for (int g = 0; g < groups; ++g) {
        std::vector<Sphere> spheres;
        const int size = 1 + g % spheres_per_group;
        const double scale = std::ldexp(1, random.below(60) - 30);
        for (int k = 0; k < size; ++k) spheres.push_back(random_sphere(random, scale));
        const SphereGroup group = group_spheres(spheres).front();
        for (int k = 0; k < 16; ++k) {
            const Ray ray = random_ray(random, spheres[k % size], g + k);
            const std::uint32_t seen = glance(group, ray, ray.t_max);
            ASSERT_EQ(seen >> size, 0u) << "a lane without a sphere";
            for (int lane = 0; lane < size; ++lane) {
                float t;
                const bool met = intersect(spheres[lane], ray, t);
                const bool maybe = seen >> lane & 1;
                ++lanes, hits += met, kept += maybe;
                lost += met && !maybe;
                naive_lost += met && !naive_hit(group, lane, ray);
            }
        }
    }
    figure("GLANCE", std::to_string(hits) + " hits of spheres, of which lost", double(lost), 0,
           double(naive_lost));
    EXPECT_LT(kept - hits, (lanes - hits) / 4); // it drops most of what is missed
}

// Closest hits in a litter of more spheres than a group holds, against one by one.
TEST(SphereGlance, finds_what_one_by_one_finds) {
    Random random(20);
    for (int k = 0; k < rays(300, 20000); ++k) {
        World world;
        for (int i = 0; i < 40; ++i) {
            world.add(Sphere{random.direction(), std::ldexp(1.0f, -random.below(12)), {}});
            if (i % 8 == 0) world.add(world.spheres.back()); // a tie
        }
        const SceneView scene = world.view();
        for (int r = 0; r < 20; ++r) {
            const Ray ray = {random.direction(), random.direction()};
            Hit brute;
            for (int i = 0; i < scene.spheres.size; ++i) {
                float t;
                if (intersect(scene.spheres[i], ray, t) &&
                    brute.is_beaten_by(t, scene.spheres[i].tags.id))
                    brute = {t, scene.spheres[i].tags.id, Shape::sphere, i};
            }
            const Hit hit = intersect<feature::sphere>(scene, ray);
            ASSERT_EQ(hit.id, brute.id);
            ASSERT_EQ(hit.t, brute.t);
            ASSERT_EQ(occluded<feature::sphere>(scene, ray), brute.found());
        }
    }
}

} // namespace
} // namespace raylab
