// FRES-EXACT and SCHLICK-BOUND: Fresnel's equations against double precision and complex
// arithmetic.
#include "common/material/fresnel.h"

#include <gtest/gtest.h>

#include <complex>

namespace raylab {
namespace {

// Unpolarised reflectance of an interface, in double, for the very floats the code under test gets.
double truth(double cos_i, double eta) {
    const double sin2_t = (1 - cos_i * cos_i) / (eta * eta);
    if (sin2_t >= 1) return 1;
    const double cos_t = std::sqrt(1 - sin2_t);
    const double parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    const double perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    return (parallel * parallel + perpendicular * perpendicular) / 2;
}

// How near to total reflection, relative: 0 at the critical angle.
double distance_to_critical(double cos_i, double eta) {
    return eta < 1 ? std::abs((1 - cos_i * cos_i) / (eta * eta) - 1) : 1;
}

constexpr int angles = 100'000;
constexpr float iors[] = {1.1f, 1.33f, 1.5f, 2.0f, 2.4f};

// Largest |F - truth| over angles spaced evenly in theta; `near` takes those beside the critical
// angle.
struct Worst {
    double far = 0, near = 0;
};
template <class F> Worst worst_error(float eta, const F& fresnel) {
    Worst worst;
    for (int i = 0; i <= angles; ++i) {
        const float cos_i = std::cos(M_PI / 2 * i / angles);
        const double error = std::abs(fresnel(cos_i, eta) - truth(cos_i, eta));
        double& w = distance_to_critical(cos_i, eta) < 1e-3 ? worst.near : worst.far;
        w = std::max(w, error);
    }
    return worst;
}

TEST(FresExact, dielectric_agrees_with_double_precision) {
    double far = 0, near = 0;
    for (const float ior : iors)
        for (const float eta : {ior, 1 / ior}) {
            const Worst worst = worst_error(eta, fresnel_dielectric);
            EXPECT_LE(worst.far, 1e-6) << "eta " << eta;
            // Beside the critical angle F = 1 - c sqrt(distance) would turn an ulp into 3e-4.
            EXPECT_LE(worst.near, 1e-6) << "eta " << eta;
            far = std::max(far, worst.far), near = std::max(near, worst.near);
        }
    // The same formula in float throughout.
    double naive_near = 0;
    for (const float ior : iors) {
        const auto naive = [](float c, float n) {
            const float sin2_t = (1 - c * c) / (n * n);
            if (sin2_t >= 1) return 1.0f;
            const float t = std::sqrt(1 - sin2_t);
            return (sqr((n * c - t) / (n * c + t)) + sqr((c - n * t) / (c + n * t))) / 2;
        };
        naive_near = std::max(naive_near, worst_error(1 / ior, naive).near);
    }
    EXPECT_GT(naive_near, 1e-5);
    RecordProperty("naive_error_near_critical", std::to_string(naive_near * 1e6) + "e-6");
    RecordProperty("error", std::to_string(far * 1e6) + "e-6");
    RecordProperty("error_near_critical", std::to_string(near * 1e6) + "e-6");
}

TEST(FresExact, extremes_are_defined) {
    for (const float ior : iors)
        for (const float eta : {ior, 1 / ior}) {
            EXPECT_FLOAT_EQ(fresnel_dielectric(1, eta), sqr((eta - 1) / (eta + 1)));
            EXPECT_EQ(fresnel_dielectric(0, eta), 1);
            EXPECT_FLOAT_EQ(fresnel_dielectric(1.0000001f, eta), fresnel_dielectric(1, eta));
            EXPECT_EQ(fresnel_dielectric(-1e-7f, eta), 1);
        }
    EXPECT_EQ(fresnel_dielectric(0.5f, 1), 0) << "no interface, no reflection";
}

TEST(SchlickBound, error_outside_is_the_published_one) {
    constexpr double bounds[] = {0.211, 0.060, 0.036, 0.044, 0.074}; // ior 1.1, 1.33, 1.5, 2, 2.4
    for (int i = 0; i < 5; ++i) {
        const double worst = worst_error(iors[i], fresnel_dielectric_schlick).far;
        // Within 1 %, and half a unit of the last digit that the table gives.
        EXPECT_NEAR(worst, bounds[i], 0.01 * bounds[i] + 0.0005) << "ior " << iors[i];
        EXPECT_GT(worst, 1e-6) << "FRES-EXACT would not notice the approximation";
        RecordProperty("error_" + std::to_string(int(iors[i] * 100)), std::to_string(worst));
    }
}

TEST(SchlickBound, from_inside_the_refracted_angle_counts_and_total_reflection_is_exact) {
    for (int i = 0; i < 5; ++i) {
        const float eta = 1 / iors[i];
        const double inside = worst_error(eta, fresnel_dielectric_schlick).far;
        const double outside = worst_error(iors[i], fresnel_dielectric_schlick).far;
        EXPECT_NEAR(inside, outside, 0.01 * outside + 1e-3) << "F is the same from both sides";
        for (int k = 0; k <= 1000; ++k) {
            const float cos_i = k / 1000.0f;
            EXPECT_EQ(fresnel_dielectric_schlick(cos_i, eta) == 1, truth(cos_i, eta) == 1);
        }
        // The usual mistake: the angle inside the glass, which never sees total reflection.
        const auto naive = [](float cos_i, float n) {
            return schlick(sqr((n - 1) / (n + 1)), cos_i);
        };
        EXPECT_GT(worst_error(eta, naive).far, 0.8);
    }
}

double conductor_truth(double cos_i, double eta, double k) {
    using Complex = std::complex<double>;
    const Complex n(eta, k);
    const Complex cos_t = std::sqrt(1.0 - (1 - cos_i * cos_i) / (n * n));
    const Complex parallel = (n * cos_i - cos_t) / (n * cos_i + cos_t);
    const Complex perpendicular = (cos_i - n * cos_t) / (cos_i + n * cos_t);
    return (std::norm(parallel) + std::norm(perpendicular)) / 2;
}

TEST(FresExact, conductor_agrees_with_complex_arithmetic) {
    // Gold, copper, aluminium (red, green, blue; eta and k of PBR's tables), and hard cases: almost
    // a dielectric, almost a perfect mirror, index below 1.
    constexpr float metals[][2] = {{0.143f, 3.983f}, {0.375f, 2.386f}, {1.442f, 1.603f},
                                   {0.200f, 3.912f}, {0.924f, 2.452f}, {1.102f, 2.142f},
                                   {1.657f, 9.224f}, {0.880f, 6.270f}, {0.521f, 4.837f},
                                   {1.5f, 1e-4f},    {1e-3f, 10.0f},   {0.3f, 0.05f}};
    double worst = 0, naive_worst = 0;
    for (const auto& [eta, k] : metals)
        for (int i = 0; i < 2000; ++i) {
            const float cos_i = std::cos(M_PI / 2 * i / 2000);
            const double expected = conductor_truth(cos_i, eta, k);
            const double F = fresnel_conductor(cos_i, eta, k);
            worst = std::max(worst, std::abs(F - expected));
            EXPECT_NEAR(F, expected, 2e-6) << eta << " + " << k << "i at " << cos_i;

            // The usual form, which takes a from a cancelling sum when k is large: it errs in 1 -
            // F.
            const float cos2 = cos_i * cos_i, sin2 = 1 - cos2, re = eta * eta - k * k - sin2;
            const float m = std::sqrt(re * re + 4 * eta * eta * k * k);
            const float a = std::sqrt(std::fmax((m + re) / 2, 0.0f)), s1 = m + cos2,
                        s2 = 2 * a * cos_i;
            const float rs = (s1 - s2) / (s1 + s2), p1 = cos2 * m + sin2 * sin2, p2 = s2 * sin2;
            const float naive = (rs + rs * (p1 - p2) / (p1 + p2)) / 2;
            naive_worst = std::max(naive_worst, std::abs(naive - expected));
        }
    EXPECT_GT(naive_worst, 2e-6);
    RecordProperty("error", std::to_string(worst * 1e6) + "e-6");
    RecordProperty("naive_error", std::to_string(naive_worst * 1e6) + "e-6");
}

// What a scene may ask for, 1e-6 to 1e6 (k from 0), at all angles down to cosines of 1e-9.
TEST(FresExact, holds_for_all_indices_that_scenes_may_have) {
    using Complex = std::complex<long double>;
    const auto exact = [](long double cos_i, Complex n) { // as a ratio: n may be near 0 or huge
        const Complex s = std::sqrt((n * n - 1.0L) + cos_i * cos_i); // n cos_t
        const Complex perpendicular = (cos_i - s) / (cos_i + s);
        const Complex parallel = (n * n * cos_i - s) / (n * n * cos_i + s);
        return double(std::norm(perpendicular) + std::norm(parallel)) / 2;
    };
    double worst_metal = 0, worst_glass = 0;
    for (int i = -12; i <= 12; ++i)
        for (int angle = 0; angle <= 60; ++angle) {
            const float eta = float(std::pow(10.0, i / 2.0));
            const float cos_i = angle % 2 ? float(std::cos(M_PI / 2 * angle / 60))
                                          : float(std::pow(10.0, -angle * 0.15));
            worst_glass =
                std::max(worst_glass, std::abs(fresnel_dielectric(cos_i, eta) - exact(cos_i, eta)));
            for (int j = -13; j <= 12; ++j) {
                const float k = j == -13 ? 0 : float(std::pow(10.0, j / 2.0));
                worst_metal = std::max(worst_metal, std::abs(fresnel_conductor(cos_i, eta, k) -
                                                             exact(cos_i, Complex(eta, k))));
            }
        }
    EXPECT_LE(worst_glass, 2e-6);
    EXPECT_LE(worst_metal, 2e-6);
    EXPECT_FALSE(fresnel_conductor(0.5f, 1, 1e10f) <= 1) << "the limit might be lifted";
    EXPECT_FALSE(fresnel_dielectric(0.5f, 1e20f) <= 1) << "the limit might be lifted";
}

TEST(FresExact, a_perfect_conductor_reflects_all) {
    for (const float cos_i : {0.0f, 1e-4f, 0.3f, 1.0f})
        EXPECT_EQ(fresnel_conductor(cos_i, 0, 1), 1);
}

TEST(Fresnel, the_material_chooses_the_model) {
    Material m;
    m.ior = 1.1f;
    EXPECT_EQ(dielectric_reflectance(m, 0.1f, 1.1f), fresnel_dielectric(0.1f, 1.1f));
    m.eta = Vec3(0.2f, 0.9f, 1.1f), m.k = Vec3(3.9f, 2.5f, 2.1f);
    EXPECT_EQ(conductor_reflectance(m, 0.3f).y, fresnel_conductor(0.3f, 0.9f, 2.5f));
    m.fresnel = FresnelModel::schlick;
    EXPECT_EQ(dielectric_reflectance(m, 0.1f, 1.1f), fresnel_dielectric_schlick(0.1f, 1.1f));
    EXPECT_EQ(conductor_reflectance(m, 1).z, fresnel_conductor(1, 1.1f, 2.1f));
    EXPECT_EQ(conductor_reflectance(m, 0).z, 1);
}

} // namespace
} // namespace raylab
