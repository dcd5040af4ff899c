// Microfacet distributions: GGX-SMOOTH, GGX-FURN, GGX-GRAZE and the identities of masking.
#include "common/material/bsdf.h"
#include "common/sampling/tests/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace raylab {
namespace {

constexpr Microfacets both_kinds[] = {Microfacets::ggx, Microfacets::beckmann};
const char* name(Microfacets kind) { return kind == Microfacets::ggx ? "ggx" : "beckmann"; }

Vec3 at_cosine(float mu, float phi = 0.3f) {
    const float s = std::sqrt((1 - mu) * (1 + mu));
    return Vec3(s * std::cos(phi), s * std::sin(phi), mu);
}

// D in double, by the textbook's tan(theta), for the very floats of m.
double D_truth(Microfacets kind, double alpha, Vec3 m) {
    const double r2 = double(m.x) * m.x + double(m.y) * m.y, z2 = double(m.z) * m.z;
    const double t = r2 / z2 / (alpha * alpha);
    const double scale = M_PI * alpha * alpha * z2 * z2;
    return kind == Microfacets::ggx ? 1 / (scale * (1 + t) * (1 + t)) : std::exp(-t) / scale;
}

TEST(GgxSmooth, D_keeps_its_digits_down_to_alpha_1e_minus_5) {
    test::Random random(1);
    double worst = 0, naive_worst = 0;
    int naive_broken = 0;
    for (const float alpha : {1e-1f, 1e-2f, 1e-3f, 1e-4f, 1e-5f})
        for (int i = 0; i < 20'000; ++i) {
            const float theta = alpha * random.between(0.01f, 3);
            const Vec3 m =
                normalize(at_cosine(1) + std::tan(theta) * Vec3(at_cosine(0, 6 * random.u())));
            const double truth = D_truth(Microfacets::ggx, alpha, m);
            const double error = MicrofacetDistribution{Microfacets::ggx, alpha}.D(m) / truth - 1;
            worst = std::max(worst, std::abs(error));
            // The usual form (alpha^2 - 1) z^2 + 1.
            const float a2 = alpha * alpha, d = (a2 - 1) * m.z * m.z + 1;
            const double naive = a2 / (pi * d * d) / truth - 1;
            if (alpha == 1e-3f) naive_worst = std::max(naive_worst, std::abs(naive));
            if (alpha < 1e-3f) naive_broken += !(std::abs(naive) < 0.5);
        }
    EXPECT_LE(worst, 1e-6);
    EXPECT_GT(naive_worst, 0.05) << "the usual form should fail at alpha 1e-3";
    EXPECT_GT(naive_broken, 10'000) << "and be useless below";
    RecordProperty("error", std::to_string(worst * 1e7) + "e-7");
    RecordProperty("naive_error_1e-3", std::to_string(naive_worst));
}

TEST(GgxSmooth, below_1e_minus_3_a_metal_is_a_mirror) {
    Material m;
    m.kind = MaterialKind::conductor;
    m.eta = Vec3(0), m.k = Vec3(1);
    m.alpha = 0.99e-3f;
    EXPECT_TRUE(is_specular<feature::all>(m));
    const Vec3 wo = at_cosine(0.4f);
    const BsdfSample s = sample_bsdf<feature::all>(m, Vec3(0.5f), wo, 0, Vec2(0.3f, 0.6f));
    EXPECT_TRUE(s.valid && s.specular);
    EXPECT_EQ(s.wi, Vec3(-wo.x, -wo.y, wo.z));
    EXPECT_EQ(s.weight, Vec3(0.5f));
    m.alpha = 1e-3f;
    EXPECT_FALSE(is_specular<feature::all>(m));
}

// The hemisphere's normals on a square (s, phi) that gives the peak of width alpha its fair share:
//   tan(theta)^2 = alpha^2 x / (1 - x),  1 - x = (1 - s)^2;
// the second step tames the tail of GGX, whose visible area falls as slowly as 1 / sqrt(1 - x).
struct NormalOnSquare {
    double x, y, z;
    double measure; // solid angle of ds dphi

    NormalOnSquare(double alpha, double s, double phi) {
        const double rest = (1 - s) * (1 - s);
        const double tan2 = alpha * alpha * (1 - rest) / rest;
        z = 1 / std::sqrt(1 + tan2);
        x = std::sqrt(tan2) * z * std::cos(phi), y = std::sqrt(tan2) * z * std::sin(phi);
        // dcos = z^3 / 2 dtan2, dtan2 = alpha^2 / rest^2 dx, dx = 2 (1 - s) ds
        measure = z * z * z * alpha * alpha / (rest * rest) * (1 - s);
    }
};

const int n_s = test::count(400, 1600), n_phi = n_s;

double integrate_normals(double alpha, const std::function<double(Vec3)>& f) {
    double sum = 0;
    for (int i = 0; i < n_s; ++i)
        for (int k = 0; k < n_phi; ++k) {
            const NormalOnSquare m(alpha, (i + 0.5) / n_s, 2 * M_PI * (k + 0.5) / n_phi);
            sum += f(Vec3(m.x, m.y, m.z)) * m.measure;
        }
    return sum * 2 * M_PI / (double(n_s) * n_phi);
}

// What makes a distribution and its masking one surface (Heitz, Understanding the Masking-Shadowing
// Function, 2014): the facets' projected area is 1, and the visible ones fill exactly what the
// surface fills as seen from wo.
TEST(Microfacets, areas_and_visible_areas_add_up) {
    for (const Microfacets kind : both_kinds)
        for (const float alpha : {1e-3f, 0.05f, 0.3f, 1.0f}) {
            SCOPED_TRACE(testing::Message() << name(kind) << " alpha " << alpha);
            const MicrofacetDistribution d{kind, alpha};
            EXPECT_NEAR(integrate_normals(alpha, [&](Vec3 m) { return d.D(m) * m.z; }), 1, 2e-4);
            for (const float mu : {1.0f, 0.5f, 0.1f, 0.01f}) {
                const Vec3 wo = at_cosine(mu);
                const double visible = integrate_normals(alpha, [&](Vec3 m) {
                    return d.G1(wo) * d.D(m) * std::max(dot(wo, m), 0.0f) / mu;
                });
                EXPECT_NEAR(visible, 1, 2e-3) << "mu " << mu;
            }
        }
}

TEST(Microfacets, sampled_normals_follow_their_density) {
    // Cells of x = t / (1 + t), t = tan^2 / alpha^2, and phi; the expected counts by the integral
    // of pdf over each cell. False alarm 1e-4 for each of 16.
    for (const Microfacets kind : both_kinds)
        for (const float alpha : {1e-3f, 0.3f})
            for (const float mu : {1.0f, 0.5f, 0.1f, 0.01f}) {
                const MicrofacetDistribution d{kind, alpha};
                const Vec3 wo = at_cosine(mu);
                std::vector<double> observed(256), expected(256);
                const int n = test::count(50'000, 500'000);
                const auto cell = [&](Vec3 m) {
                    const double r2 = double(m.x) * m.x + double(m.y) * m.y;
                    const double tan2 = r2 / (double(m.z) * m.z);
                    const double s = 1 - alpha / std::sqrt(alpha * alpha + tan2);
                    double turn = std::atan2(double(m.y), double(m.x)) / (2 * M_PI);
                    turn -= std::floor(turn);
                    return std::min(int(16 * s), 15) * 16 + std::min(int(16 * turn), 15);
                };
                test::Random random(7);
                for (int i = 0; i < n; ++i) ++observed[cell(d.sample(wo, random.square()))];
                for (int i = 0; i < n_s; ++i)
                    for (int k = 0; k < n_phi; ++k) {
                        const NormalOnSquare m(alpha, (i + 0.5) / n_s,
                                               2 * M_PI * (k + 0.5) / n_phi);
                        const double p = std::max(d.pdf(wo, Vec3(m.x, m.y, m.z)), 0.0f);
                        expected[i * 16 / n_s * 16 + k * 16 / n_phi] +=
                            n * p * m.measure * 2 * M_PI / (double(n_s) * n_phi);
                    }
                EXPECT_GT(test::chi_square_p(observed, expected), 1e-4)
                    << name(kind) << " alpha " << alpha << " mu " << mu;
            }
}

Material white_metal(float alpha, Microfacets kind = Microfacets::ggx) {
    Material m;
    m.kind = MaterialKind::conductor;
    m.eta = Vec3(0), m.k = Vec3(1); // F = 1 at all angles
    m.alpha = alpha;
    m.microfacets = kind;
    return m;
}

// Albedo of a white GGX metal by quadrature in double of Torrance and Sparrow's f cos_i dwi, with
// f = D G1 G1 / (4 mu cos_i) and dwi = 4 (wo.m) dm.
double ggx_albedo(double alpha, double mu) {
    const double so = std::sqrt(1 - mu * mu);
    const auto G1 = [&](double z) {
        return 2 / (1 + std::sqrt(1 + alpha * alpha * (1 - z * z) / (z * z)));
    };
    double sum = 0;
    for (int i = 0; i < n_s; ++i)
        for (int k = 0; k < n_phi; ++k) {
            const NormalOnSquare m(alpha, (i + 0.5) / n_s, M_PI * (k + 0.5) / n_phi); // symmetric
            const double om = so * m.x + mu * m.z, cos_i = 2 * om * m.z - mu;
            if (om <= 0 || cos_i <= 0) continue;
            const double t = (m.x * m.x + m.y * m.y) / (alpha * alpha * m.z * m.z);
            const double D = 1 / (M_PI * alpha * alpha * m.z * m.z * m.z * m.z * (1 + t) * (1 + t));
            sum += D * G1(mu) * G1(cos_i) * om / mu * m.measure;
        }
    return sum * 2 * M_PI / (double(n_s) * n_phi);
}

TEST(GgxFurn, albedo_of_a_white_metal) {
    EXPECT_NEAR(ggx_albedo(1, 1), 1 - std::log(2), 1e-5) << "closed form";
    double worst = 0;
    for (const float alpha : {0.01f, 0.1f, 0.3f, 0.5f, 1.0f})
        for (const float mu : {1.0f, 0.5f, 0.1f, 0.01f}) {
            const Material m = white_metal(alpha);
            const Vec3 wo = at_cosine(mu);
            test::Random random(1);
            test::Mean albedo;
            for (int i = 0; i < test::count(20'000, 2'000'000); ++i) {
                const BsdfSample s = sample_bsdf<feature::all>(m, Vec3(1), wo, 0, random.square());
                albedo.add(s.valid ? s.weight.x : 0);
            }
            const double truth = ggx_albedo(alpha, mu);
            EXPECT_NEAR(albedo.mean(), truth, 4 * albedo.standard_error() + 5e-4)
                << "alpha " << alpha << " mu " << mu;
            EXPECT_LE(albedo.mean(), 1);
            worst = std::max(worst, std::abs(albedo.mean() - truth));
            if (alpha == 1 && mu == 1) RecordProperty("E_1_1", std::to_string(albedo.mean()));
        }
    RecordProperty("worst", std::to_string(worst));
}

TEST(GgxGraze, weights_stay_in_the_unit_interval_and_directions_unit) {
    constexpr float extremes[] = {0, 0x1p-24f, 0.25f, 0.5f, 0.75f, 1 - 0x1p-24f};
    test::Random random(1);
    for (const float alpha : {1e-3f, 1e-2f, 0.1f, 1.0f})
        for (const float mu : {1e-2f, 1e-3f, 1e-4f, 1e-5f, 1e-6f, 1e-7f}) {
            const Material m = white_metal(alpha);
            const auto check = [&](Vec2 u) {
                const Vec3 wo = at_cosine(mu, 6 * random.u());
                const BsdfSample s = sample_bsdf<feature::all>(m, Vec3(1), wo, 0, u);
                if (!s.valid) return;
                ASSERT_TRUE(s.weight.x >= 0 && s.weight.x <= 1) << s.weight.x << " mu " << mu;
                ASSERT_TRUE(std::isfinite(s.pdf) && s.pdf > 0) << s.pdf << " mu " << mu;
                ASSERT_NEAR(length(s.wi), 1, 1e-6) << "mu " << mu;
            };
            for (const float x : extremes)
                for (const float y : extremes) check(Vec2(x, y));
            for (int i = 0; i < test::count(10'000, 400'000); ++i) check(random.square());
        }
}

} // namespace
} // namespace raylab
