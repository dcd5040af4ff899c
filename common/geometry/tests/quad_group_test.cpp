// The glance at sixteen quads: what it drops is missed, where it is sure the ray is inside.
#include "common/geometry/tests/support.h"

#include <gtest/gtest.h>

namespace raylab {
namespace {

using namespace test;

// A quad of a random shape, size and place: parallelogram, trapezoid or sliver, flat to rounding.
// Its size is `scale` up to a factor of 2^16. (Beyond 2^49 no quad can be told from an edge: the
// exact test takes the undecided for hit, where the glance knows that they are far apart.)
Quad random_quad(Random& random, double scale, int k) {
    const double size = scale * std::ldexp(1, random.below(16));
    const DVec3 at = size * random.unit() * std::ldexp(1, int(12 * random.uniform()));
    const DVec3 e1 = size * random.unit();
    DVec3 e2 = size * random.unit();
    if (k % 3 == 1) e2 *= 1e-3;
    const double top = k % 4 == 2 ? 0.3 + random.uniform() : 1;
    return make_quad(Vec3(at), Vec3(at + e1), Vec3(at + e2 + top * e1), Vec3(at + e2));
}

// A ray towards a place in the quad, near its border or through it, from close by or far away.
Ray random_ray(Random& random, const Quad& quad, int k) {
    const auto place = [&] {
        const double x = random.uniform();
        return k % 5 == 0 ? 0.0 : k % 5 == 1 ? 1.0 : k % 5 == 2 ? std::ldexp(x, -22) : x;
    };
    const double s = place(), t = random.uniform();
    const DVec3 v0(quad.v[0]), v1(quad.v[1]), v2(quad.v[2]), v3(quad.v[3]);
    const DVec3 target = (1 - t) * ((1 - s) * v0 + s * v1) + t * ((1 - s) * v3 + s * v2);
    const double size = glm::length(v1 - v0) * std::ldexp(1, int(16 * random.uniform()) - 8);
    DVec3 away = random.unit();
    if (k % 7 == 3) away -= 0.9999 * dot(away, DVec3(quad.normal)) * DVec3(quad.normal); // grazing
    const Vec3 o(target + size * glm::normalize(away));
    const Vec3 d = normalize(Vec3(target - DVec3(o)));
    return {o, d, k % 11 == 5 ? float(size) : infinity};
}

// What a glance without a margin would say.
bool naive_hit(const QuadGroup& group, int lane, const Ray& ray) {
    const auto along = [&](const float(&v)[3][quads_per_group], Vec3 p) {
        return v[0][lane] * p.x + v[1][lane] * p.y + v[2][lane] * p.z;
    };
    const float t = (group.offset[lane] - along(group.normal, ray.o)) / along(group.normal, ray.d);
    const float c0 = along(group.across[0], ray(t)) - group.start[0][lane];
    const float c1 = along(group.across[1], ray(t)) - group.start[1][lane];
    return t > 0 && t < ray.t_max && c0 >= 0 && c0 <= 1 && c1 >= 0 && c1 <= 1;
}

TEST(QuadGlance, loses_no_hit_and_is_sure_only_of_hits) {
    Random random(9);
    long hits = 0, lost = 0, late = 0, unsure = 0, wrong = 0, naive_lost = 0;
    const int groups = rays(2000, 200000);
    for (int g = 0; g < groups; ++g) {
        std::vector<Quad> quads;
        const int size = 1 + g % quads_per_group;
        const double scale = std::ldexp(1, random.below(60) - 30);
        for (int k = 0; k < size; ++k) quads.push_back(random_quad(random, scale, g + k));
        const QuadGroup group = group_quads(quads).front();
        for (int k = 0; k < 16; ++k) {
            const Ray ray = random_ray(random, quads[k % size], g + k);
            const QuadGlance seen = glance(group, ray, ray.t_max);
            ASSERT_EQ(seen.maybe >> size, 0u) << "a lane without a quad";
            for (int lane = 0; lane < size; ++lane) {
                float t = infinity, t_inside = infinity;
                const bool met = intersect(quads[lane], ShearedRay(ray), t);
                const bool maybe = seen.maybe >> lane & 1;
                hits += met;
                lost += met && !maybe;
                late += met && maybe && seen.begin[lane] > t;
                naive_lost += met && !naive_hit(group, lane, ray);
                if (maybe && (seen.sure >> lane & 1)) {
                    const bool inside = intersect_inside(quads[lane], ray, t_inside);
                    wrong += inside != met || (met && t != t_inside);
                } else {
                    unsure += met;
                }
            }
        }
    }
    figure("GLANCE", std::to_string(hits) + " hits, of which lost", double(lost), 0,
           double(naive_lost));
    figure("GLANCE", "hits before the lane begins", double(late), 0);
    figure("GLANCE", "sure, and not inside or at another t", double(wrong), 0);
    EXPECT_LT(unsure, hits); // it is sure of some
}

// Closest hits in a litter of more quads than a group holds, against one by one.
TEST(QuadGlance, finds_what_one_by_one_finds) {
    Random random(10);
    for (int k = 0; k < rays(300, 20000); ++k) {
        World world;
        for (int i = 0; i < 40; ++i) {
            const DVec3 at = random.unit(), e1 = random.unit();
            const DVec3 e2 = random.unit();
            world.add(make_quad(Vec3(at), Vec3(at + e1), Vec3(at + e1 + e2), Vec3(at + e2)));
            if (i % 8 == 0) world.add(world.quads.back()); // a tie
        }
        const SceneView scene = world.view();
        for (int r = 0; r < 20; ++r) {
            const Ray ray = {random.direction(), random.direction()};
            Hit brute;
            for (int i = 0; i < scene.quads.size; ++i) {
                float t;
                if (intersect(scene.quads[i], ShearedRay(ray), t) &&
                    brute.is_beaten_by(t, scene.quads[i].tags.id))
                    brute = {t, scene.quads[i].tags.id, Shape::quad, i};
            }
            const Hit hit = intersect<feature::quad>(scene, ray);
            ASSERT_EQ(hit.id, brute.id);
            ASSERT_EQ(hit.t, brute.t);
            ASSERT_EQ(occluded<feature::quad>(scene, ray), brute.found());
        }
    }
}

} // namespace
} // namespace raylab
