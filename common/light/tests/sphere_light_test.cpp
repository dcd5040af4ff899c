// SPHLIGHT: the cone's density and irradiance from a sphere, at any size; and light from inside it.
#include "common/light/tests/light_scene.h"
#include "common/sampling/tests/statistics.h"

#include <gtest/gtest.h>

#include <numbers>

namespace raylab {
namespace {

constexpr float ratios[] = {0.9f, 0.5f, 0.1f, 1e-2f, 1e-3f, 1e-4f, 1e-5f, 1e-6f, 1e-7f, 1e-8f};

TEST(SphLight, density_is_that_of_the_cone_at_every_size) {
    double worst = 0;
    bool naive_infinite = false;
    double naive_at_1e_3 = 0;
    for (const float ratio : ratios) {
        test::LightScene scene;
        scene.add(Vec3(0, 0, 1), ratio);
        const LightSample s = sample_light<F>(scene.view(), 0, Vec3(0), Vec2(0.3f, 0.6f));
        const long double r2 = (long double)ratio * ratio;
        const long double truth =
            1 / (2 * std::numbers::pi_v<long double> * (r2 / (1 + std::sqrt(1 - r2))));
        worst = std::max(worst, double(std::abs(s.pdf / truth - 1)));
        EXPECT_NEAR(s.pdf / truth, 1, 1e-6) << "r/d " << ratio;
        EXPECT_EQ(light_pdf<F>(scene.view(), 0, Vec3(0), s.wi, s.p, s.n), s.pdf);
        const float naive = inv_two_pi / (1 - std::sqrt(1 - ratio * ratio));
        if (ratio == 1e-3f) naive_at_1e_3 = std::abs(naive / truth - 1);
        naive_infinite |= std::isinf(naive);
    }
    EXPECT_GT(naive_at_1e_3, 0.01) << "1 - cos should fail here";
    EXPECT_TRUE(naive_infinite);
    RecordProperty("error", std::to_string(worst * 1e8) + "e-8");
    RecordProperty("naive_error_1e-3", std::to_string(naive_at_1e_3));
}

// E = pi L (r/d)^2 cos(tilt) while the sphere is wholly above the horizon.
TEST(SphLight, irradiance_is_the_closed_form) {
    double worst = 0;
    for (const float ratio : ratios)
        for (const double tilt : {0.0, 0.3, 0.6, 1.0}) {
            if (tilt + std::asin(ratio) > M_PI / 2) continue;
            test::LightScene scene(Vec3(2));
            scene.add(Vec3(std::sin(tilt), 0, std::cos(tilt)) * 3.0f, 3 * ratio);
            test::Random random(1);
            test::Mean E;
            for (int i = 0; i < test::count(20'000, 1'000'000); ++i) {
                const LightSample s = sample_light<F>(scene.view(), 0, Vec3(0), random.square());
                ASSERT_TRUE(s.valid && s.wi.z > 0);
                E.add(s.radiance.x * s.wi.z / s.pdf);
            }
            const double truth = 2 * M_PI * double(ratio) * ratio * std::cos(tilt);
            EXPECT_NEAR(E.mean() / truth, 1, 4 * E.standard_error() / truth + 1e-6)
                << "r/d " << ratio << " tilt " << tilt;
            worst = std::max(worst, std::abs(E.mean() / truth - 1));
        }
    RecordProperty("worst", std::to_string(worst));
}

TEST(SphLight, points_lie_on_the_visible_side_where_the_direction_meets_the_sphere) {
    test::Random random(2);
    for (int i = 0; i < 200'000; ++i) {
        const float ratio = std::pow(10.0f, -4 * random.u()) * 0.999f;
        const float d = std::pow(10.0f, random.between(-3, 3));
        const Vec3 from = d * Vec3(random.u(), random.u(), random.u());
        const Vec3 center = from + d * random.direction();
        test::LightScene scene;
        scene.add(center, ratio * d);
        const LightSample s = sample_light<F>(scene.view(), 0, from, random.square());
        ASSERT_TRUE(s.valid);
        const DVec3 out = DVec3(s.p) - DVec3(center);
        ASSERT_LE(std::abs(glm::length(out) - ratio * d), s.error) << "r/d " << ratio;
        ASSERT_NEAR(length(s.n), 1, 3e-7);
        ASSERT_LE(dot(s.wi, s.n), 1e-3f) << "behind the horizon, r/d " << ratio;
        // p lies in the direction wi: apart by rounding of p, seen from its distance.
        const DVec3 to = DVec3(s.p) - DVec3(from);
        const double apart = glm::length(to / glm::length(to) - DVec3(s.wi));
        ASSERT_LE(apart, 1e-6 + 4 * s.error / s.distance) << "r/d " << ratio;
        ASSERT_NEAR(s.distance / glm::length(to), 1, 1e-6);
    }
}

// From inside, the whole sphere of directions shines: E over the hemisphere is pi L, and the
// density integrates to 1. Away from the center area sampling has variance.
TEST(SphLight, from_inside_the_irradiance_is_pi) {
    for (const float offset : {0.0f, 0.5f, 0.99f, 1.0f}) {
        test::LightScene scene;
        scene.add(Vec3(1, 2, 3), 2);
        const Vec3 from = Vec3(1, 2, 3) + Vec3(2 * offset, 0, 0);
        test::Random random(3);
        test::Mean E;
        for (int i = 0; i < test::count(200'000, 5'000'000); ++i) {
            const LightSample s = sample_light<F>(scene.view(), 0, from, random.square());
            if (!s.valid) continue;
            ASSERT_TRUE(std::isfinite(s.pdf) && s.pdf > 0);
            ASSERT_NEAR(light_pdf<F>(scene.view(), 0, from, s.wi, s.p, s.n) / s.pdf, 1, 1e-4);
            E.add(s.radiance.x * std::max(-s.wi.x, 0.0f) / s.pdf);
        }
        EXPECT_NEAR(E.mean(), M_PI, 4 * E.standard_error()) << "offset " << offset;
        // On the sphere itself: pdf = d / (2 r A cos) ... every sample's cos/pdf is the same.
        EXPECT_LT(E.standard_error(), 0.05);
    }
}

// A point on the sphere, rounded a little outside, must not see the sphere as a half space whose
// nearest point is the point itself.
TEST(SphLight, a_point_on_the_surface_counts_as_inside) {
    test::Random random(4);
    for (int i = 0; i < 100'000; ++i) {
        const Vec3 center = 10.0f * Vec3(random.u(), random.u(), random.u());
        test::LightScene scene;
        scene.add(center, 0.5f);
        const DVec3 n(random.direction());
        const Vec3 on(DVec3(center) + 0.5 * glm::normalize(n)); // rounded once
        EXPECT_FALSE(cone_around(scene.spheres[0], on).exists);
        const LightSample s = sample_light<F>(scene.view(), 0, on, random.square());
        EXPECT_TRUE(!s.valid || is_finite(s.wi));
    }
}

// Far away in x alone: only where its surface faces x is a point less certain than it is at 0.
TEST(SphLight, each_axis_is_rounded_by_its_own_coordinate) {
    test::Random random(7);
    test::LightScene scene;
    scene.add(Vec3(65536, 0.05f, 0), 0.01f);
    const Vec3 from(65536, 0, 0.001f);
    ASSERT_TRUE(cone_around(scene.spheres[0], from).exists);
    for (int i = 0; i < 1000; ++i) {
        const LightSample s = sample_light<F>(scene.view(), 0, from, random.square());
        ASSERT_TRUE(s.valid);
        ASSERT_LE(s.error, 1e-8 + 65536 * 0x1p-22 * std::fabs(s.n.x));
    }
}

TEST(SphLight, scaling_by_a_power_of_two_changes_no_bit_but_the_scale) {
    test::Random random(5);
    for (const float k : {0x1p-20f, 0x1p20f})
        for (int i = 0; i < 1000; ++i) {
            const Vec3 center = 3.0f * random.direction();
            const float radius = 3.3f * random.u() + 0.01f; // from outside and from inside
            test::LightScene one, scaled;
            one.add(center, radius);
            scaled.add(k * center, k * radius);
            const Vec2 u = random.square();
            const LightSample a = sample_light<F>(one.view(), 0, Vec3(0), u);
            const LightSample b = sample_light<F>(scaled.view(), 0, Vec3(0), u);
            ASSERT_EQ(a.wi, b.wi);
            ASSERT_EQ(a.pdf, b.pdf);
            ASSERT_EQ(k * a.p, b.p);
            ASSERT_EQ(k * a.error, b.error);
            ASSERT_EQ(k * a.distance, b.distance);
        }
}

// U-EDGE
TEST(UEdge, every_sphere_light_sample_is_finite) {
    constexpr float edges[] = {0, 0x1p-32f, 0x1p-24f, 0.5f, 1 - 0x1p-24f, 1};
    for (const float ratio : {2.0f, 1.0f, 0.999999f, 0.5f, 1e-4f, 1e-8f})
        for (const float x : edges)
            for (const float y : edges) {
                test::LightScene scene;
                scene.add(Vec3(0, 0, 1), ratio);
                const LightSample s = sample_light<F>(scene.view(), 0, Vec3(0), Vec2(x, y));
                if (!s.valid) continue;
                EXPECT_TRUE(is_finite(s.p) && is_finite(s.wi) && s.pdf > 0);
                EXPECT_NEAR(length(s.wi), 1, 1e-6) << ratio << " " << x << " " << y;
            }
}

TEST(PointLight, radiance_falls_with_the_square_of_the_distance) {
    test::LightScene scene;
    scene.lights.push_back({LightKind::point, -1, Vec3(0, 0, 2), Vec3(8)});
    const LightSample s = sample_light<F>(scene.view(), 0, Vec3(0), Vec2(0.5f));
    EXPECT_TRUE(s.valid && s.delta);
    EXPECT_EQ(s.radiance, Vec3(2));
    EXPECT_EQ(s.pdf, 1);
    EXPECT_EQ(s.wi, Vec3(0, 0, 1));
    EXPECT_EQ(s.distance, 2);
    EXPECT_EQ(light_pdf<F>(scene.view(), 0, Vec3(0), s.wi, s.p, s.n), 0) << "no ray meets it";
    EXPECT_FALSE(sample_light<F>(scene.view(), 0, Vec3(0, 0, 2), Vec2(0.5f)).valid);
}

} // namespace
} // namespace raylab
