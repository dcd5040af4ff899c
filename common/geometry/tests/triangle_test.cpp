// Triangles without area, needles, NaN; which of several at the same place is hit.
#include "common/geometry/tests/naive.h"
#include "common/geometry/tests/support.h"

#include <algorithm>
#include <limits>

namespace raylab::test {
namespace {

Triangle random_triangle(Random& random) {
    const DVec3 at = 4.0 * random.unit();
    return make_triangle(Vec3(at + random.unit()), Vec3(at + random.unit()),
                         Vec3(at + random.unit()));
}

Ray random_ray(Random& random) {
    return {Vec3(6.0 * random.uniform() * random.unit()), random.direction()};
}

TEST(TRI_DEGEN, triangles_without_area_or_with_nan_change_nothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Random random(21);
    World clean, littered;
    for (int i = 0; i < 200; ++i) {
        Triangle good = random_triangle(random);
        good.tags = {i, 0, -1};
        clean.triangles.push_back(good);
        littered.triangles.push_back(good);
        // Collinear corners that float holds exactly; a repeated corner; a point; a NaN.
        const Vec3 a(random.below(9) - 4, random.below(9) - 4, random.below(9) - 4);
        const Vec3 step(random.below(5) - 2, random.below(5) - 2, 1);
        for (Triangle bad : {make_triangle(a, a + step, a + 3.0f * step),
                             make_triangle(good.v[0], good.v[0], good.v[1]), make_triangle(a, a, a),
                             make_triangle(good.v[0], Vec3(nan, 0, 0), good.v[2])}) {
            bad.tags = {-2, 0, -1};
            littered.triangles.push_back(bad);
        }
    }
    clean.make_runs(0), littered.make_runs(0);
    const SceneView with = littered.view(), without = clean.view();
    int different = 0, found = 0, nan_t = 0, naive_hits = 0;
    for (int i = 0; i < rays(10'000, 200'000); ++i) {
        Ray ray = random_ray(random);
        if (i % 2) { // at a corner of a degenerate triangle, where it could matter
            const Triangle& bad = littered.triangles[5 * random.below(200) + 1 + random.below(2)];
            ray.d = Vec3(glm::normalize(DVec3(bad.v[1]) - DVec3(ray.o)));
        }
        const Hit a = intersect<feature::triangle>(with, ray);
        const Hit b = intersect<feature::triangle>(without, ray);
        different += !same_hit(a, b);
        found += a.found();
        nan_t += std::isnan(a.t);
        float naive_t;
        for (const Triangle& triangle : littered.triangles)
            naive_hits +=
                triangle.tags.id == -2 && naive::moller_trumbore(triangle, ray, 0, 0, naive_t);
    }
    EXPECT_GT(found, 1000);
    figure("TRI-DEGEN", "rays that hit otherwise (naive: hits of nothing)", different, 0,
           naive_hits);
    figure("TRI-DEGEN", "NaN", nan_t, 0);
}

// None of its edges can be told from the ray's own rounding: that is no reason to hit it
// everywhere.
TEST(TRI_DEGEN, a_triangle_too_small_to_see_is_not_hit_from_afar) {
    Random random(23);
    int hits = 0;
    for (int i = 0; i < 10'000; ++i) {
        const Triangle speck = make_triangle(
            1e-17f * random.direction(), 1e-17f * random.direction(), 1e-17f * random.direction());
        float t;
        hits += intersect(speck, ShearedRay({random.direction(), random.direction()}), t);
    }
    figure("TRI-DEGEN", "hits of a speck of 1e-17 from a distance of 1", hits, 0);
}

// At a distance of 1 double resolves some 1e-15. That is room for a triangle's own size beside it,
// not for the ray to pass it anywhere. The naive variant: one error for all edges, by the distance.
TEST(TRI_DEGEN, a_tiny_triangle_or_quad_is_hit_by_what_meets_it_alone) {
    Random random(24);
    int hits = 0, quad_hits = 0, naive_hits = 0, missed = 0, quad_missed = 0;
    for (int i = 0; i < rays(20'000, 1'000'000); ++i) {
        const double size = std::pow(10, random.between(-16, -9));
        const DVec3 x = size * random.unit();
        const DVec3 y = size * glm::normalize(cross(x, random.unit()));
        const Triangle triangle = make_triangle(Vec3(0), Vec3(x), Vec3(y));
        const Quad quad = make_quad(Vec3(0), Vec3(x), Vec3(x + y), Vec3(y));
        const Vec3 o = random.direction();
        // Past it, by more than the rounding of a direction.
        const DVec3 side = glm::normalize(cross(DVec3(o), random.unit()));
        const DVec3 beside = std::pow(10, random.between(-6, 0)) * side;
        const ShearedRay past({o, Vec3(glm::normalize(beside - DVec3(o)))});
        float t;
        hits += intersect(triangle, past, t);
        quad_hits += intersect(quad, past, t);
        const Corner a = past(triangle.v[0]), b = past(triangle.v[1]), c = past(triangle.v[2]);
        naive_hits += encloses(
            edge(a, b), edge(b, c), edge(c, a),
            edge_error(std::max({a.width, b.width, c.width}), std::max({a.size, b.size, c.size})));
        // At it, from as near as its size allows, unless it is seen edge-on.
        if (fabs(dot(glm::normalize(cross(x, y)), DVec3(o))) < 0.1) continue;
        const ShearedRay at({Vec3(1e3 * size * DVec3(o) + (x + y) / 4.0), -o});
        missed += !intersect(triangle, at, t);
        quad_missed += !intersect(quad, at, t);
    }
    figure("TRI-DEGEN", "hits of a tiny triangle by rays past it", hits, 0, naive_hits);
    figure("TRI-DEGEN", "hits of a tiny quad by rays past it", quad_hits, 0);
    figure("TRI-DEGEN", "rays that miss a tiny triangle", missed, 0);
    figure("TRI-DEGEN", "rays that miss a tiny quad", quad_missed, 0);
}

TEST(TRI_DEGEN, a_needle_is_hit_where_it_is) {
    Random random(22);
    int found = 0, bad = 0;
    double worst = 0, naive_worst = 0;
    for (int i = 0; i < rays(50'000, 500'000); ++i) {
        const DVec3 at = 3.0 * random.unit(), e1 = random.unit();
        const DVec3 e2 = 0.5 * e1 + 1e-6 * glm::normalize(cross(e1, random.unit()));
        const Triangle needle = make_triangle(Vec3(at), Vec3(at + e1), Vec3(at + e2));
        const RVec v0(needle.v[0]), w1 = RVec(needle.v[1]) - v0, w2 = RVec(needle.v[2]) - v0;
        const double s = random.between(0, 0.5);
        const RVec target = v0 + Real(s) * w1 + Real(random.between(0, 1 - s)) * w2;
        const Vec3 o(5.0 * random.unit());
        const Ray ray{o, Vec3(glm::normalize(target - RVec(o)))};
        float t;
        if (!intersect(needle, ShearedRay(ray), t)) continue;
        ++found;
        const Real exact_t = dot(target - RVec(o), RVec(ray.d)) / dot(RVec(ray.d), RVec(ray.d));
        // The needle's plane is seen at any angle: only the depth range of its corners is certain.
        bad += !std::isfinite(t) || fabsl(t - exact_t) > 1e-5 * exact_t + 1;
        const RVec n = cross(w1, w2);
        const Real cosine = fabsl(dot(glm::normalize(n), RVec(ray.d)));
        if (cosine < 0.1) continue;
        const Real plane_t = dot(n, v0 - RVec(o)) / dot(n, RVec(ray.d));
        worst = std::max(worst, double(fabsl(t - plane_t) / plane_t));
        if (naive::moller_trumbore(needle, ray, 0, 0, t))
            naive_worst = std::max(naive_worst, double(fabsl(t - plane_t) / plane_t));
    }
    EXPECT_GT(found, 1000);
    figure("TRI-DEGEN", "needle 1:1e6, wrong or NaN", bad, 0);
    figure("TRI-DEGEN", "needle 1:1e6, t", worst, 1e-6, naive_worst);
}

// --- DUP-COPLANAR -----------------------------------------------------------------------------

// Every surface twice, and coplanar overlapping ones: ties wherever a ray goes.
World tied_world() {
    World world;
    Random random(31);
    for (int i = 0; i < 40; ++i) {
        const Triangle triangle = random_triangle(random);
        world.add(triangle);
        world.add(triangle);
        const Quad quad = make_quad(Vec3(-2, -2, i % 5), Vec3(2, -2, i % 5), Vec3(2, 2, i % 5),
                                    Vec3(-2, 2, i % 5));
        world.add(quad);
        const float x = float(random.below(4)) - 2, z = float(i % 5);
        world.add(make_triangle(Vec3(x, -2, z), Vec3(x + 2, -1, z), Vec3(x, 2, z)));
        world.add(Sphere{random.direction(), 0.5f, {}});
        world.add(world.spheres.back());
        world.add(Plane{Vec3(0, 0, i % 5), Vec3(0, 0, 1), {}});
    }
    world.make_runs(0);
    return world;
}

template <class T> void shuffle(std::vector<T>& items, Random& random) {
    for (int i = int(items.size()) - 1; i > 0; --i) std::swap(items[i], items[random.below(i + 1)]);
}

// "Nearer wins, else the first": what a loop without the tie rule returns.
int first_of_nearest(const World& world, const Ray& ray) {
    float best = infinity, t;
    int id = -1;
    for (const Quad& quad : world.quads)
        if (intersect(quad, ShearedRay(ray), t) && t < best) best = t, id = quad.tags.id;
    for (const Triangle& triangle : world.triangles)
        if (intersect(triangle, ShearedRay(ray), t) && t < best) best = t, id = triangle.tags.id;
    return id;
}

TEST(DUP_COPLANAR, the_lowest_id_wins_in_any_order) {
    const World original = tied_world();
    World shuffled = original;
    Random random(32);
    std::vector<Ray> all;
    for (int i = 0; i < rays(1'000, 50'000); ++i) all.push_back(random_ray(random));
    int different = 0, naive_different = 0, not_lowest = 0, found = 0;
    for (int permutation = 0; permutation < 10; ++permutation) {
        shuffle(shuffled.spheres, random), shuffle(shuffled.quads, random);
        shuffle(shuffled.planes, random), shuffle(shuffled.triangles, random);
        for (const Ray& ray : all) {
            const Hit a = intersect<all_shapes>(original.view(), ray);
            const Hit b = intersect<all_shapes>(shuffled.view(), ray);
            different += !same_hit(a, b);
            naive_different += first_of_nearest(original, ray) != first_of_nearest(shuffled, ray);
            found += a.found();
            float t;
            for (const Quad& quad : original.quads)
                not_lowest +=
                    intersect(quad, ShearedRay(ray), t) && t == a.t && quad.tags.id < a.id;
        }
    }
    EXPECT_GT(found, 5000);
    figure("DUP-COPLANAR", "hits that depend on the order (naive: first wins)", different, 0,
           naive_different);
    figure("DUP-COPLANAR", "hits whose id is not the lowest", not_lowest, 0);
}

} // namespace
} // namespace raylab::test
