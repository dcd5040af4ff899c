// The first glance at eight triangles never contradicts the exact test: it drops nothing that is
// hit, is sure of nothing that is missed, and knows within which t.
#include "common/geometry/tests/support.h"
#include "common/geometry/triangle.h"
#include "labs/04_accel/leaf/packs.h"
#include "labs/04_accel/tests/cases.h"

#include <algorithm>

namespace raylab::lab04 {

namespace {

// Of any size and shape: needles, corners next to each other, in a plane of the axes, far from the
// origin in comparison with its size.
Triangle any_triangle(Dice& dice) {
    const float size = power_of_two(dice, -20, 0);
    const Vec3 place = dice.below(2) ? dice.point(-1, 1) : Vec3(0);
    Vec3 v[3];
    for (Vec3& corner : v) corner = dice.point(-size, size);
    switch (dice.below(4)) {
    case 0: // a needle
        v[2] = glm::mix(v[0], v[1], dice.between(0, 1)) + power_of_two(dice, -24, 0) * v[2];
        break;
    case 1: // a short edge
        v[2] = v[1] + power_of_two(dice, -24, 0) * v[2];
        break;
    case 2: // across an axis
        v[0].z = v[1].z = v[2].z;
        break;
    }
    Triangle triangle{};
    for (int corner = 0; corner < 3; ++corner) triangle.v[corner] = place + v[corner];
    return triangle;
}

// At a corner, an edge, or any point around it, from anywhere, or from far away.
Ray ray_at(const Triangle& triangle, Dice& dice) {
    const Vec3 &a = triangle.v[0], &b = triangle.v[1], &c = triangle.v[2];
    const float along[] = {0, 1, dice.between(0, 1)}, inwards[] = {0, 0, dice.between(-0.5f, 1)};
    const Vec3 target = glm::mix(glm::mix(a, b, along[dice.below(3)]), c, inwards[dice.below(3)]);
    const Vec3 o = target + power_of_two(dice, -20, 6) * dice.direction();
    const Vec3 way = target - o;
    return {o, dot(way, way) > 0 ? normalize(way) : dice.direction()};
}

// Is the triangle seen so much from its edge that the exact test's own room for rounding, 2^-49 of
// its size (see edge_error()), moves the hit along it by more than a float's last digits? Then the
// ray may pass it by, and count as a hit at a t that none of its corners has.
bool is_thin(const Triangle& triangle, const Ray& ray) {
    const ShearedRay sheared(ray);
    const Corner a = sheared(triangle.v[0]), b = sheared(triangle.v[1]), c = sheared(triangle.v[2]);
    const double area = std::fabs(edge(a, b) + edge(b, c) + edge(c, a));
    const double width = std::max({a.width, b.width, c.width}),
                 size = std::max({a.size, b.size, c.size});
    return area < 0x1p-24 * width * size;
}

struct Verdict {
    int hits = 0;    // by the exact test
    int sure = 0;    // of those, known to the glance
    int dropped = 0; // a hit that the glance excludes
    int wrong = 0;   // a miss of which the glance is sure that it is a hit
    int outside = 0; // a hit at a t that is not within the glance's interval
};

// errors: what the margin is made of, in u width size; none: as the glance has it.
Verdict judge(int rays, auto... errors) {
    Dice dice(21);
    Verdict verdict;
    for (int i = 0; i < rays; ++i) {
        // All of about the same place, so that each ray grazes one and passes by the others.
        std::vector<Triangle> triangles;
        for (int k = 0; k < triangles_per_pack; ++k) triangles.push_back(any_triangle(dice));
        Ray ray = ray_at(triangles[dice.below(triangles_per_pack)], dice);
        const float scale = power_of_two(dice, -30, 30);
        for (Triangle& triangle : triangles)
            for (Vec3& v : triangle.v) v *= scale;
        ray.o *= scale;
        std::vector<TrianglePack> packs;
        append_packs(triangles, std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}, packs);
        const TriangleGlance seen =
            glance(packs[0], GlanceRay(ray, SlabRay(ray).inv_d), infinity, errors...);
        for (int k = 0; k < triangles_per_pack; ++k) {
            float t = 0;
            const bool hit = intersect(triangles[k], ShearedRay(ray), t);
            const bool maybe = seen.maybe >> k & 1, sure = maybe && (seen.sure >> k & 1);
            verdict.hits += hit;
            verdict.sure += sure && hit;
            verdict.dropped += hit && !maybe;
            verdict.wrong += !hit && sure && seen.begin[k] > 0;
            const bool within = seen.begin[k] <= t && t <= seen.end[k];
            verdict.outside += hit && maybe && !within && !is_thin(triangles[k], ray);
        }
    }
    return verdict;
}

TEST(Glance, NeverContradictsTheExactTest) {
    const Verdict verdict = judge(test::rays(300000, 10000000));
    EXPECT_GT(verdict.hits, 50000);
    EXPECT_GT(verdict.sure, 20000);
    EXPECT_EQ(verdict.dropped, 0);
    EXPECT_EQ(verdict.wrong, 0);
    EXPECT_EQ(verdict.outside, 0);
}

// The test above would see a margin that is too small: of a twentieth hundreds are lost.
TEST(Glance, NeedsItsMargin) {
    const Verdict verdict = judge(300000, 0.8f);
    EXPECT_GT(verdict.dropped, 100);
    EXPECT_GT(verdict.wrong, 50);
}

} // namespace

} // namespace raylab::lab04
