// Reflection and refraction: Snell's law, pairs in and out, total reflection, and DRIFT.
#include "common/material/glass.h"
#include "common/material/refract.h"
#include "common/sampling/tests/statistics.h"

#include <gtest/gtest.h>

namespace raylab {
namespace {

Vec3 above(test::Random& random, Vec3 n) {
    const Vec3 d = random.direction();
    return dot(d, n) < 0 ? -d : d;
}

TEST(Refract, obeys_snells_law_in_the_plane_of_incidence) {
    test::Random random(1);
    for (int i = 0; i < 100'000; ++i) {
        const Vec3 n = random.direction(), wo = above(random, n);
        const float eta = random.between(1.01f, 3);
        const Refraction r = refract(wo, n, eta);
        ASSERT_FALSE(r.total);
        ASSERT_NEAR(length(r.wi), 1, 1e-6);
        ASSERT_LT(dot(r.wi, n), 0);
        ASSERT_NEAR(glm::length(cross(DVec3(wo), DVec3(n))),
                    eta * glm::length(cross(DVec3(r.wi), DVec3(n))), 2e-6);
        ASSERT_NEAR(dot(cross(wo, n), r.wi), 0, 1e-6);
        ASSERT_LE(dot(cross(wo, n), cross(r.wi, n)), 1e-6) << "bends through, not back";
    }
}

TEST(Refract, out_undoes_in) {
    test::Random random(2);
    for (int i = 0; i < 100'000; ++i) {
        const Vec3 n = random.direction(), wo = above(random, n);
        const float eta = random.between(1.01f, 3);
        const Refraction in = refract(wo, n, eta);
        const Refraction out = refract(in.wi, -n, 1 / eta);
        // At grazing incidence the way out is the critical angle, where an ulp moves cos by its
        // root.
        const float tolerance = 2e-6f / std::max(dot(wo, n), 1e-3f);
        ASSERT_TRUE(!out.total || dot(wo, n) < 1e-3f);
        ASSERT_NEAR(length(out.wi - wo), 0, tolerance) << dot(wo, n);
    }
}

TEST(Refract, total_reflection_is_flagged_and_never_nan) {
    test::Random random(3);
    const Vec3 n(0, 0, 1);
    int naive_nans = 0;
    for (int i = 0; i < 100'000; ++i) {
        const float eta = 1 / random.between(1.01f, 3);
        const Vec3 wo = above(random, n);
        const Refraction r = refract(wo, n, eta);
        ASSERT_TRUE(is_finite(r.wi));
        const double sin2 = (1 - double(wo.z) * wo.z) / (double(eta) * eta);
        ASSERT_TRUE(r.total == (sin2 > 1) || std::abs(sin2 - 1) < 1e-5);
        naive_nans += std::isnan(std::sqrt(1 - (1 - wo.z * wo.z) / (eta * eta)));
    }
    EXPECT_GT(naive_nans, 10000) << "the square root without a clamp should fail here";
    for (const float z : {0.0f, 1e-7f, 1e-20f, 1.0f})
        for (const float eta : {0.4f, 1.0f, 1.5f})
            EXPECT_TRUE(is_finite(refract(Vec3(std::sqrt(1 - z * z), 0, z), n, eta).wi));
}

TEST(Drift, a_thousand_events_keep_directions_unit) {
    test::Random random(4);
    double worst = 0, naive_worst = 0;
    for (int path = 0; path < test::count(200, 5000); ++path) {
        Vec3 d = random.direction(), naive = d;
        float eta = 1.5f;
        for (int event = 0; event < 1000; ++event) {
            const Vec3 n = above(random, d);
            const Refraction r = refract(d, n, eta);
            if (event % 3 == 0 || r.total) {
                d = reflect(d, n);
            } else {
                d = r.wi;
                eta = 1 / eta;
            }
            // Reflection with a normal that is unit only to 1e-3: what skipping normalize() does.
            naive = reflect(naive, n * 1.0005f);
        }
        worst = std::max(worst, std::abs(std::sqrt(double(dot(d, d))) - 1));
        naive_worst = std::max(naive_worst, double(std::abs(length(naive) - 1)));
    }
    EXPECT_LE(worst, 1e-5);
    EXPECT_GT(naive_worst, 1e-3);
    RecordProperty("drift", std::to_string(worst * 1e6) + "e-6");
}

TEST(FresnelSplit, gives_both_ways_from_both_sides) {
    Material glass;
    glass.kind = MaterialKind::glass;
    glass.ior = 1.5f;
    const FresnelSplit outside = fresnel_split(glass, Vec3(0.6f, 0, 0.8f));
    EXPECT_EQ(outside.reflected, Vec3(-0.6f, 0, 0.8f));
    EXPECT_NEAR(outside.refracted.x, -0.4, 1e-7);
    EXPECT_NEAR(outside.refracted.z, -std::sqrt(1 - 0.16), 1e-7);
    EXPECT_FLOAT_EQ(outside.reflectance, fresnel_dielectric(0.8f, 1.5f));

    const FresnelSplit inside = fresnel_split(glass, Vec3(0.4f, 0, -std::sqrt(1 - 0.16f)));
    EXPECT_NEAR(inside.refracted.x, -0.6, 1e-7);
    EXPECT_NEAR(inside.refracted.z, 0.8, 1e-6);
    EXPECT_NEAR(inside.reflectance, outside.reflectance, 1e-6) << "F is the same from both sides";
    EXPECT_EQ(fresnel_split(glass, Vec3(0.8f, 0, -0.6f)).reflectance, 1) << "total reflection";
}

} // namespace
} // namespace raylab
