// POLYLIGHT: quads and triangles against Lambert's formula; uniformity over any convex quad.
#include "common/light/tests/light_scene.h"
#include "common/sampling/tests/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace raylab {
namespace {

// Irradiance at the origin, normal +z, from a polygon of radiance 1 above the horizon: half the sum
// over edges of their angle times the z of the edge plane's normal (Lambert 1760; Baum et al.
// 1989).
double lambert(const std::vector<Vec3>& polygon) {
    double E = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const DVec3 a = glm::normalize(DVec3(polygon[i]));
        const DVec3 b = glm::normalize(DVec3(polygon[(i + 1) % polygon.size()]));
        const DVec3 n = cross(a, b);
        const double sine = glm::length(n);
        if (sine > 0) E += std::atan2(sine, dot(a, b)) * n.z / sine;
    }
    return std::abs(E) / 2;
}

test::Mean irradiance(const test::LightScene& scene, int n) {
    test::Random random(1);
    test::Mean E;
    for (int i = 0; i < n; ++i) {
        const LightSample s = sample_light<F>(scene.view(), 0, Vec3(0), random.square());
        E.add(s.valid ? s.radiance.x * std::max(s.wi.z, 0.0f) / s.pdf : 0);
    }
    return E;
}

TEST(PolyLight, unit_square_agrees_with_lambert) {
    // Receiver (0.3, -0.2) off the axis of the unit square at height h; the published values.
    constexpr double heights[] = {1, 0.1, 0.01};
    constexpr double published[] = {0.6492081358, 2.9014064814, 3.1388310990};
    for (int i = 0; i < 3; ++i) {
        const float h = heights[i];
        const std::vector<Vec3> v = {
            {-0.8f, -0.3f, h}, {0.2f, -0.3f, h}, {0.2f, 0.7f, h}, {-0.8f, 0.7f, h}};
        EXPECT_NEAR(lambert(v), published[i], 1e-6);
        test::LightScene quad;
        quad.add(v[0], v[1], v[2], v[3]);
        const test::Mean E = irradiance(quad, test::count(200'000, 10'000'000));
        EXPECT_NEAR(E.mean(), published[i], 4 * E.standard_error() + 1e-5) << "h " << h;
        RecordProperty("E_" + std::to_string(i),
                       std::to_string(E.mean()) + " +- " + std::to_string(E.standard_error()));
    }
}

// Convex planar quads: square, parallelogram, trapezoid, kite, one almost a triangle.
std::vector<std::vector<Vec3>> quads() {
    return {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
            {{0, 0, 1}, {2, 0.5f, 1}, {2.5f, 1.5f, 1}, {0.5f, 1, 1}},
            {{-1, 0, 1}, {1, 0, 1}, {0.3f, 1, 1}, {-0.3f, 1, 1}},
            {{0, -1, 1}, {0.5f, 0, 1}, {0, 0.4f, 1}, {-0.5f, 0, 1}},
            {{0, 0, 1}, {1, 0, 1}, {0.5001f, 0.5f, 1}, {0, 1, 1}}};
}

TEST(PolyLight, any_convex_quad_and_triangle_agree_with_lambert) {
    for (const auto& v : quads()) {
        test::LightScene quad, triangle;
        quad.add(v[0], v[1], v[2], v[3]);
        triangle.add(v[0], v[1], v[3]);
        const test::Mean E = irradiance(quad, test::count(50'000, 5'000'000));
        EXPECT_NEAR(E.mean(), lambert(v), 4 * E.standard_error() + 1e-5);
        const test::Mean T = irradiance(triangle, test::count(50'000, 5'000'000));
        EXPECT_NEAR(T.mean(), lambert({v[0], v[1], v[3]}), 4 * T.standard_error() + 1e-5);
    }
}

double area(Vec3 a, Vec3 b, Vec3 c) { return length(cross(b - a, c - a)) / 2; }

// Points counted in horizontal strips, whose areas by clipping are exact; and left and right of
// their median line. Naive: the bilinear map of (u.x, u.y) without the correction for its varying
// area.
TEST(PolyLight, points_are_uniform_over_any_convex_quad) {
    for (const auto& v : quads()) {
        test::LightScene scene;
        scene.add(v[0], v[1], v[2], v[3]);
        // Four triangles from a point inside: areas known, membership by signs.
        const Vec3 inside = 0.25f * (v[0] + v[1] + v[2] + v[3]);
        const auto count_triangles = [&](auto&& point) {
            test::Random random(2);
            std::vector<double> observed(16), expected(16);
            const int n = test::count(200'000, 5'000'000);
            double total = 0;
            for (int i = 0; i < 4; ++i) total += area(inside, v[i], v[(i + 1) % 4]);
            for (int i = 0; i < 4; ++i) {
                const double whole = area(inside, v[i], v[(i + 1) % 4]) / total * n;
                for (int k = 0; k < 4; ++k) expected[4 * i + k] = whole / 4;
            }
            for (int i = 0; i < n; ++i) {
                const Vec3 p = point(random.square());
                for (int k = 0; k < 4; ++k) {
                    const Vec3 a = v[k] - inside, b = v[(k + 1) % 4] - inside, q = p - inside;
                    const double det = double(a.x) * b.y - double(a.y) * b.x;
                    const double s = (double(q.x) * b.y - double(q.y) * b.x) / det;
                    const double t = (double(a.x) * q.y - double(a.y) * q.x) / det;
                    if (s < 0 || t < 0) continue;
                    // Within the triangle s + t = sqrt(uniform), s / (s + t) uniform.
                    const int ring = std::min(int(2 * (s + t) * (s + t)), 1);
                    ++observed[4 * k + 2 * ring + (s > t)];
                    break;
                }
            }
            return test::chi_square_p(observed, expected);
        };
        const double p = count_triangles(
            [&](Vec2 u) { return sample_light<F>(scene.view(), 0, Vec3(0, 0, -5), u).p; });
        EXPECT_GT(p, 1e-4); // false alarm 1e-4 for each of 5
        const double naive = count_triangles(
            [&](Vec2 u) { return lerp(lerp(v[0], v[1], u.x), lerp(v[3], v[2], u.x), u.y); });
        const bool parallelogram = length(v[0] - v[1] + v[2] - v[3]) == 0;
        EXPECT_TRUE(parallelogram || naive < 1e-9) << naive;
    }
}

TEST(PolyLight, a_parallelogram_keeps_the_strata_of_u) {
    test::LightScene scene;
    scene.add(Vec3(0, 0, 1), Vec3(2, 0, 1), Vec3(2, 1, 1), Vec3(0, 1, 1));
    for (const Vec2 u : {Vec2(0, 0), Vec2(0.25f, 0.75f), Vec2(one_minus_epsilon, 0.5f)}) {
        const LightSample s = sample_light<F>(scene.view(), 0, Vec3(0), u);
        EXPECT_NEAR(s.p.x, 2 * u.x, 1e-6);
        EXPECT_NEAR(s.p.y, u.y, 1e-6);
    }
}

// The density over all directions integrates to 1: a uniform direction, its hit with the light's
// plane by hand, light_pdf there; the mean times 4 pi. And sample_light's own density is the same.
TEST(PolyLight, density_integrates_to_one_and_is_the_sampler_s) {
    for (const auto& v : quads())
        for (const bool triangle : {false, true}) {
            test::LightScene scene;
            if (triangle)
                scene.add(v[0], v[1], v[3]);
            else
                scene.add(v[0], v[1], v[2], v[3]);
            const Vec3 n(0, 0, 1);
            test::Random random(3);
            test::Mean integral;
            for (int i = 0; i < test::count(200'000, 5'000'000); ++i) {
                const Vec3 d = random.direction();
                const Vec3 p = d / d.z; // z = 1 is the lights' plane
                bool hit = d.z > 0;
                const std::vector<Vec3> corners =
                    triangle ? std::vector<Vec3>{v[0], v[1], v[3]} : v;
                for (std::size_t k = 0; k < corners.size(); ++k)
                    hit =
                        hit &&
                        cross(corners[(k + 1) % corners.size()] - corners[k], p - corners[k]).z > 0;
                integral.add(hit ? 4 * M_PI * light_pdf<F>(scene.view(), 0, Vec3(0), d, p, n) : 0);
            }
            EXPECT_NEAR(integral.mean(), 1, 4 * integral.standard_error());
            for (int i = 0; i < 1000; ++i) {
                const LightSample s = sample_light<F>(scene.view(), 0, Vec3(0), random.square());
                ASSERT_TRUE(s.valid);
                ASSERT_NEAR(light_pdf<F>(scene.view(), 0, Vec3(0), s.wi, s.p, s.n) / s.pdf, 1,
                            1e-5);
                ASSERT_LE(std::abs(double(s.p.z) - 1), s.error);
                ASSERT_NEAR(length(s.wi), 1, 1e-6);
            }
        }
}

TEST(PolyLight, emits_from_both_sides_and_not_edge_on) {
    test::LightScene scene(Vec3(3));
    scene.add(Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0));
    const Vec2 u(0.4f, 0.7f);
    const LightSample above = sample_light<F>(scene.view(), 0, Vec3(0, 0, 2), u);
    const LightSample below = sample_light<F>(scene.view(), 0, Vec3(0, 0, -2), u);
    EXPECT_TRUE(above.valid && below.valid);
    EXPECT_EQ(above.pdf, below.pdf);
    EXPECT_EQ(below.radiance, Vec3(3));
    const LightSample edge_on = sample_light<F>(scene.view(), 0, Vec3(5, 0, 0), u);
    EXPECT_FALSE(edge_on.valid);
    EXPECT_EQ(light_pdf<F>(scene.view(), 0, Vec3(5, 0, 0), edge_on.wi, edge_on.p, edge_on.n), 0);
}

TEST(PolyLight, scaling_by_a_power_of_two_changes_no_bit_but_the_scale) {
    test::Random random(5);
    for (const float k : {0x1p-30f, 0x1p30f})
        for (const auto& v : quads()) {
            test::LightScene one, scaled, one_triangle, scaled_triangle;
            one.add(v[0], v[1], v[2], v[3]);
            scaled.add(k * v[0], k * v[1], k * v[2], k * v[3]);
            one_triangle.add(v[0], v[1], v[2]);
            scaled_triangle.add(k * v[0], k * v[1], k * v[2]);
            for (int i = 0; i < 200; ++i) {
                const Vec2 u = random.square();
                const Vec3 from = random.direction();
                const auto compare = [&](const test::LightScene& x, const test::LightScene& y) {
                    const LightSample a = sample_light<F>(x.view(), 0, from, u);
                    const LightSample b = sample_light<F>(y.view(), 0, k * from, u);
                    ASSERT_EQ(a.wi, b.wi);
                    ASSERT_EQ(a.pdf, b.pdf);
                    ASSERT_EQ(k * a.p, b.p);
                };
                compare(one, scaled);
                compare(one_triangle, scaled_triangle);
            }
        }
}

// U-EDGE
TEST(UEdge, every_polygon_light_sample_is_finite) {
    constexpr float edges[] = {0, 0x1p-32f, 0x1p-24f, 0.5f, 1 - 0x1p-24f, 1};
    for (const auto& v : quads()) {
        test::LightScene scene;
        scene.add(v[0], v[1], v[2], v[3]);
        scene.add(v[0], v[1], v[2]);
        for (const int light : {0, 1})
            for (const float x : edges)
                for (const float y : edges) {
                    const LightSample s = sample_light<F>(scene.view(), light, Vec3(0), Vec2(x, y));
                    ASSERT_TRUE(s.valid && is_finite(s.p) && s.pdf > 0 && std::isfinite(s.pdf));
                    ASSERT_NEAR(length(s.wi), 1, 1e-6);
                }
    }
}

} // namespace
} // namespace raylab
