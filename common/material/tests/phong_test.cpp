// PHONG-ALB: the lobe's albedo against quadrature; 1 at normal incidence, never more.
#include "common/material/bsdf.h"
#include "common/sampling/tests/statistics.h"

#include <gtest/gtest.h>

namespace raylab {
namespace {

// Integral over the upper hemisphere of (n + 2) / (2 pi) cos^n(alpha) cos(theta), in double, in
// polar coordinates around the mirrored direction: cos(alpha) = x^(1 / (n + 1)) spreads the lobe
// over x.
double lobe_albedo(double n, double mu) {
    const int n_x = 500, n_phi = 500;
    const double sine = std::sqrt(1 - mu * mu);
    double sum = 0;
    for (int i = 0; i < n_x; ++i) {
        const double c = std::pow((i + 0.5) / n_x, 1 / (n + 1)), s = std::sqrt(1 - c * c);
        for (int k = 0; k < n_phi; ++k)
            sum += std::fmax(mu * c + sine * s * std::cos(M_PI * (k + 0.5) / n_phi), 0);
    }
    return (n + 2) / (n + 1) * sum / (double(n_x) * n_phi);
}

TEST(PhongAlb, albedo_of_a_white_lobe) {
    // n = 1, mirrored direction at the angle g: ((pi - g) cos g + sin g) / pi, two clamped cosines.
    EXPECT_NEAR(lobe_albedo(1, 0.5), 1.0 / 3 + std::sqrt(0.75) / M_PI, 1e-5);
    double worst = 0;
    for (const float n : {1.0f, 10.0f, 100.0f, 1000.0f})
        for (const float mu : {1.0f, 0.5f, 0.1f}) {
            Material m;
            m.kind = MaterialKind::phong;
            m.exponent = n;
            m.specular = Vec3(1);
            const Vec3 wo(std::sqrt(1 - mu * mu), 0, mu);
            test::Random random(1);
            test::Mean albedo;
            for (int i = 0; i < test::count(100'000, 2'000'000); ++i) {
                const Vec2 u = random.square();
                const BsdfSample s = sample_bsdf<feature::all>(m, Vec3(0), wo, 0, u);
                albedo.add(s.valid ? s.weight.x : 0);
            }
            const double truth = lobe_albedo(n, mu);
            EXPECT_NEAR(albedo.mean(), truth, 4 * albedo.standard_error() + 1e-3)
                << "n " << n << " mu " << mu;
            EXPECT_LE(truth, 1.0001);
            EXPECT_NEAR(mu == 1 ? truth : 1, 1, 1e-4) << "closed form at normal incidence";
            worst = std::max(worst, std::abs(albedo.mean() - truth));
        }
    RecordProperty("worst", std::to_string(worst));
}

TEST(PhongAlb, the_unnormalised_lobe_makes_light) {
    // cos^n / cos, the lobe as Phong wrote it (1975), has no bound at grazing; the plain (n + 1)
    // form loses a part (n + 1) / (n + 2) at normal incidence.
    EXPECT_NEAR(lobe_albedo(1, 1) * (1 + 1) / (1 + 2), 2.0 / 3, 1e-5);
}

TEST(Phong, narrow_lobes_keep_their_digits) {
    // cos^n(alpha) at alpha = 1 / sqrt(n): e^-1/2 in the limit. With cos from a dot product the
    // n-th power magnifies its ulp by n.
    double worst = 0, naive_worst = 0;
    test::Random random(3);
    for (const float n : {1e3f, 1e4f, 1e5f, 1e6f})
        for (int i = 0; i < 1000; ++i) {
            const Frame frame = Frame::around(normalize(random.direction()));
            const float alpha = 1 / std::sqrt(n);
            const Vec3 b = frame.to_world(Vec3(std::sin(alpha), 0, std::cos(alpha)));
            const DVec3 d = DVec3(frame.z) - DVec3(b);
            const double truth = std::exp(n * std::log1p(-dot(d, d) / 2));
            worst = std::max(worst, std::abs(cosine_power(frame.z, b, n) / truth - 1));
            naive_worst = std::max(
                naive_worst, std::abs(std::pow(double(dot(frame.z, b)), double(n)) / truth - 1));
        }
    EXPECT_LT(worst, 1e-5);
    EXPECT_GT(naive_worst, 0.01);
    RecordProperty("error", std::to_string(worst * 1e6) + "e-6");
    RecordProperty("naive_error", std::to_string(naive_worst));
}

} // namespace
} // namespace raylab
