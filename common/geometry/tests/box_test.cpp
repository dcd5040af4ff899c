// Boxes: the slab test against exact arithmetic, the box of six quads, a grid of cubes.
#include "common/geometry/tests/naive.h"
#include "common/geometry/tests/support.h"

#include <array>

namespace raylab::test {
namespace {

// A ray and a box with small integer coordinates: everything about them is exact.
struct IntegerCase {
    int low[3], high[3], o[3], d[3];
    bool minus_zero; // the sign of zero components of d

    Ray ray() const {
        const float zero = minus_zero ? -0.0f : 0.0f;
        const auto component = [&](int k) { return d[k] ? float(d[k]) : zero; };
        return {Vec3(o[0], o[1], o[2]), Vec3(component(0), component(1), component(2))};
    }
    Bounds bounds() const {
        return {Vec3(low[0], low[1], low[2]), Vec3(high[0], high[1], high[2])};
    }
};

// The interval of t in which the whole line is in the closed box, as exact fractions.
struct Fraction {
    long long top, bottom; // bottom > 0
    bool operator<(const Fraction& f) const { return top * f.bottom < f.top * bottom; }
    double value() const { return double(top) / double(bottom); }
};

struct Interval {
    bool empty = false;
    Fraction near_t{-1'000'000, 1}, far_t{1'000'000, 1};

    explicit Interval(const IntegerCase& c) {
        for (int k = 0; k < 3; ++k) {
            if (c.d[k] == 0) {
                empty = empty || c.o[k] < c.low[k] || c.o[k] > c.high[k];
                continue;
            }
            const int sign = c.d[k] < 0 ? -1 : 1;
            const Fraction at_low{sign * (c.low[k] - c.o[k]), sign * c.d[k]};
            const Fraction at_high{sign * (c.high[k] - c.o[k]), sign * c.d[k]};
            const Fraction first = sign > 0 ? at_low : at_high, last = sign > 0 ? at_high : at_low;
            if (near_t < first) near_t = first;
            if (last < far_t) far_t = last;
        }
        empty = empty || far_t < near_t;
    }
};

// The twelve ways in which a ray can lie to a box; kind 0 to 11.
IntegerCase make_case(Random& random, int kind) {
    IntegerCase c{};
    for (int k = 0; k < 3; ++k) {
        c.low[k] = random.below(7) - 6;
        c.high[k] = c.low[k] + 1 + random.below(6);
        c.o[k] = random.below(25) - 12;
        c.d[k] = random.below(9) - 4;
    }
    c.minus_zero = random.below(2);
    const int x = random.below(3), y = (x + 1) % 3, z = (x + 2) % 3;
    const auto face = [&](int k) { return random.below(2) ? c.low[k] : c.high[k]; };
    switch (kind) {
    case 0:
        break; // anything
    case 1:
        c.d[x] = 0;
        break; // one zero component
    case 2:
        c.d[x] = c.d[y] = 0;
        break; // along an axis
    case 3:
        c.d[x] = 0, c.o[x] = face(x);
        break; // within a face's plane
    case 4:
        c.d[x] = c.d[y] = 0, c.o[x] = face(x);
        break; // the same, along an axis
    case 5:
        c.d[x] = c.d[y] = 0, c.o[x] = face(x), c.o[y] = face(y);
        break; // along an edge
    case 6:
        c.high[x] = c.low[x];
        break; // a flat box
    case 7:
        c.high[x] = c.low[x], c.d[x] = 0, c.o[x] = c.low[x];
        break; // in the flat box's plane
    case 8:
        for (int k = 0; k < 3; ++k) c.high[k] = c.low[k] + 2, c.o[k] = c.low[k] + 1;
        break; // inside
    case 9:
        c.o[x] = face(x);
        break; // from a face's plane
    case 10:
        for (int k = 0; k < 3; ++k) c.o[k] = face(k) - 3 * c.d[k];
        break; // through a corner
    case 11:
        c.o[x] = face(x) - 2 * c.d[x], c.o[y] = face(y) - 2 * c.d[y], c.d[z] = 0;
        break; // an edge
    }
    if (c.d[0] == 0 && c.d[1] == 0 && c.d[2] == 0) c.d[z] = 1;
    return c;
}

TEST(BOX_FACE, the_slab_test_misses_no_ray_that_meets_the_closed_box) {
    const int n = rays(20'000, 200'000);
    int false_hits = 0;
    for (int kind = 0; kind < 12; ++kind) {
        Random random(100 + kind);
        int meets = 0, missed = 0, naive_missed = 0;
        for (int i = 0; i < n; ++i) {
            const IntegerCase c = make_case(random, kind);
            const Interval truth(c);
            const bool is_hit = !truth.empty && !(truth.far_t < Fraction{0, 1});
            const Ray ray = c.ray();
            const bool found = crosses(c.bounds(), SlabRay(ray), infinity);
            false_hits += found && !is_hit;
            if (!is_hit) continue;
            ++meets;
            missed += !found;
            naive_missed += !naive::slabs(c.bounds(), ray);
        }
        ASSERT_GT(meets, 100) << kind;
        const bool in_face = kind == 3 || kind == 4 || kind == 5 || kind == 7;
        figure("BOX-FACE", "slabs, missed in %, class " + std::to_string(kind),
               100.0 * missed / meets, 0,
               in_face ? std::optional(100.0 * naive_missed / meets) : std::nullopt);
    }
    std::printf("  slabs: false hits %d of %d (allowed)\n", false_hits, 12 * n);
}

// t_max counts as inside: a hit exactly there may be tied with one found before.
TEST(BOX_FACE, the_slab_test_keeps_ties) {
    Random random(41);
    int lost = 0;
    for (int i = 0; i < rays(100'000, 1'000'000); ++i) {
        const DVec3 p(random.unit());
        const Vec3 o(3.0 * random.unit()), corner(p);
        const Ray ray{o, Vec3(glm::normalize(p - DVec3(o)))};
        Bounds flat;
        flat.include(corner), flat.include(corner + Vec3(1, 1, 0)),
            flat.include(corner - Vec3(1, 1, 0));
        const float t = float((double(corner.z) - o.z) / ray.d.z);
        lost += fabsf(ray.d.z) > 0.1f && !crosses(flat, SlabRay(ray), t);
    }
    figure("BOX-FACE", "slabs, ties lost at t_max", lost, 0);
}

TEST(BOX_FACE, six_quads_are_the_closed_box) {
    const int n = rays(20'000, 200'000);
    for (int kind : {0, 1, 2, 3, 4, 5, 8, 9, 10, 11}) {
        Random random(200 + kind);
        int false_misses = 0, false_hits = 0, naive_misses = 0, hits = 0;
        double worst = 0;
        for (int i = 0; i < n; ++i) {
            const IntegerCase c = make_case(random, kind);
            const Interval truth(c);
            const Bounds b = c.bounds();
            Vec3 corner[8];
            for (int k = 0; k < 8; ++k)
                corner[k] = Vec3(k & 1 ? b.high.x : b.low.x, k & 2 ? b.high.y : b.low.y,
                                 k & 4 ? b.high.z : b.low.z);
            World world;
            add_box(world, corner);
            // The far end of the interval lies on the box's surface: a hit if in front of the
            // origin.
            const bool is_hit = !truth.empty && Fraction{0, 1} < truth.far_t;
            const Hit hit = intersect<feature::quad>(world.view(), c.ray());
            false_misses += is_hit && !hit.found();
            false_hits += !is_hit && hit.found();
            if (is_hit && hit.found()) {
                const double near_t = truth.near_t.value(), far_t = truth.far_t.value();
                const double exact = near_t > 0 ? near_t : far_t;
                worst = std::max(worst, fabs(hit.t - exact) / exact);
            }
            if (!is_hit) continue;
            ++hits;
            bool naive_found = false;
            float t;
            for (const Quad& quad : world.quads) {
                Ray ray = c.ray();
                ray.d = normalize(ray.d);
                naive_found = naive_found || naive::quad(quad, ray, 1e-4f, t);
            }
            naive_misses += !naive_found;
        }
        ASSERT_GT(hits, 100);
        const std::string at = ", class " + std::to_string(kind);
        const bool at_edge = kind == 10 || kind == 11;
        figure("BOX-FACE", "six quads, false misses" + at, false_misses, 0,
               at_edge ? std::optional<double>(naive_misses) : std::nullopt);
        figure("BOX-FACE", "six quads, false hits" + at, false_hits, 0);
        figure("BOX-FACE", "six quads, t in ulps" + at, worst * 0x1p23, 4);
    }
}

// An axis-parallel camera on a grid of cubes, quarter steps apart: a quarter of the rays run
// exactly along faces or edges. Silhouettes by integer arithmetic; the box is closed.
TEST(ORTHO_GRID, silhouettes_are_exact) {
    constexpr int size = 8;
    Random random(51);
    std::array<std::array<int, size>, size> height; // of the column of cubes, 0: none
    World world;
    for (auto& row : height)
        for (int& h : row) h = random.below(2) * (1 + random.below(4));
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            for (int z = 0; z < height[y][x]; ++z) {
                Vec3 corner[8];
                for (int k = 0; k < 8; ++k)
                    corner[k] = Vec3(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2));
                add_box(world, corner);
            }
    const SceneView scene = world.view();
    int wrong = 0, naive_wrong = 0;
    for (int py = -2; py <= 4 * size + 2; ++py)
        for (int px = -2; px <= 4 * size + 2; ++px)
            for (int sign : {0, 1, 2, 3}) {
                const float zero_x = sign & 1 ? -0.0f : 0.0f, zero_y = sign & 2 ? -0.0f : 0.0f;
                const Ray ray{Vec3(px * 0.25f, py * 0.25f, 20), Vec3(zero_x, zero_y, -1)};
                int top = 0; // of the columns whose closed square the ray meets
                for (int y = 0; y < size; ++y)
                    for (int x = 0; x < size; ++x)
                        if (px >= 4 * x && px <= 4 * x + 4 && py >= 4 * y && py <= 4 * y + 4)
                            top = std::max(top, height[y][x]);
                const Hit hit = intersect<feature::quad>(scene, ray);
                wrong += top > 0 ? hit.t != float(20 - top) : hit.found();
                float nearest = infinity, t;
                for (const Quad& quad : world.quads)
                    if (naive::moller_trumbore({{quad.v[0], quad.v[1], quad.v[2]}, {}, -1, {}}, ray,
                                               1e-8f, 0, t) &&
                        t < nearest)
                        nearest = t;
                naive_wrong += top > 0 ? nearest != float(20 - top) : nearest < infinity;
            }
    figure("ORTHO-GRID", "wrong pixels (naive: one triangle a quad)", wrong, 0, naive_wrong);
}

// Skipping a run of triangles because its box is missed never changes the hit.
TEST(BOX_FACE, no_box_of_a_run_hides_a_hit) {
    const Mesh mesh = icosphere(3, 1, DVec3(0.25, -0.5, 0.125));
    World brute, boxed;
    for (int f = 0; f < int(mesh.faces.size()); ++f) brute.add(mesh.triangle(f));
    // Axis-aligned flat triangles too: boxes without thickness.
    Random random(61);
    for (int i = 0; i < 64; ++i) {
        Vec3 v[3];
        for (Vec3& p : v) p = Vec3(random.below(9) - 4, random.below(9) - 4, random.below(9) - 4);
        for (Vec3& p : v) p[i % 3] = float(i % 7 - 3);
        if (length_squared(cross(v[1] - v[0], v[2] - v[0])) > 0)
            brute.add(make_triangle(v[0], v[1], v[2]));
    }
    boxed = brute;
    brute.make_runs(0), boxed.make_runs(4);
    const SceneView a = brute.view(), b = boxed.view();
    int different = 0, found = 0;
    for (int i = 0; i < rays(4'000, 200'000); ++i) {
        const Triangle& target = brute.triangles[random.below(int(brute.triangles.size()))];
        Ray ray{Vec3(3.0 * random.uniform() * random.unit()), {}};
        if (i % 3 == 0) ray.o = Vec3(random.below(9) - 4, random.below(9) - 4, random.below(9) - 4);
        const double s = i % 2 ? random.uniform() : 0;
        ray.d = Vec3(
            glm::normalize((1 - s) * DVec3(target.v[0]) + s * DVec3(target.v[1]) - DVec3(ray.o)));
        if (!is_finite(ray.d)) continue;
        const Hit hit = intersect<feature::triangle>(a, ray);
        different += !same_hit(hit, intersect<feature::triangle>(b, ray));
        different += hit.found() != occluded<feature::triangle>(b, ray);
        found += hit.found();
    }
    EXPECT_GT(found, 1000);
    figure("BOX-FACE", "hits changed by boxes around triangles", different, 0);
}

} // namespace
} // namespace raylab::test
