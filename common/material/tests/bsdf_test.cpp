// Every BSDF: samples follow the density, densities add up, weights are f cos / pdf, f is the
// textbook's and reciprocal, no light is made.
#include "common/material/bsdf.h"
#include "common/sampling/tests/statistics.h"
#include "common/scene/variants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace raylab {
namespace {

struct Case {
    std::string name;
    Material material;
};

Material make(
    MaterialKind kind, const std::function<void(Material&)>& set = [](Material&) {}) {
    Material m;
    m.kind = kind;
    m.reflectance = Vec3(0.8f, 0.5f, 0.3f);
    set(m);
    return m;
}

Material phong(float n, Vec3 diffuse, Vec3 specular) {
    return make(MaterialKind::phong, [&](Material& m) {
        m.exponent = n, m.reflectance = diffuse, m.specular = specular;
    });
}

Material microfacet(MaterialKind kind, Microfacets microfacets, float alpha,
                    FresnelModel fresnel = FresnelModel::exact) {
    return make(kind, [&](Material& m) {
        m.microfacets = microfacets, m.alpha = alpha, m.fresnel = fresnel;
        m.reflectance = Vec3(1, 0.9f, 0.8f);
        m.eta = Vec3(0.143f, 0.375f, 1.442f), m.k = Vec3(3.983f, 2.386f, 1.603f); // gold
    });
}

// Every BSDF that has a density.
std::vector<Case> all_cases() {
    constexpr auto metal = MaterialKind::conductor, glass = MaterialKind::rough_dielectric;
    return {{"diffuse", make(MaterialKind::diffuse)},
            {"phong 1", phong(1, Vec3(0.4f), Vec3(0.5f))},
            {"phong 50", phong(50, Vec3(0.3f, 0.5f, 0.1f), Vec3(0.4f))},
            {"phong 50, lobe alone", phong(50, Vec3(0), Vec3(0.9f))},
            {"ggx metal 0.1", microfacet(metal, Microfacets::ggx, 0.1f)},
            {"ggx metal 0.5", microfacet(metal, Microfacets::ggx, 0.5f)},
            {"ggx metal 1, schlick", microfacet(metal, Microfacets::ggx, 1, FresnelModel::schlick)},
            {"beckmann metal 0.15", microfacet(metal, Microfacets::beckmann, 0.15f)},
            {"beckmann metal 0.5", microfacet(metal, Microfacets::beckmann, 0.5f)},
            {"ggx glass 0.15", microfacet(glass, Microfacets::ggx, 0.15f)},
            {"ggx glass 0.5", microfacet(glass, Microfacets::ggx, 0.5f)},
            {"beckmann glass 0.3", microfacet(glass, Microfacets::beckmann, 0.3f)}};
}

Vec3 at(float mu, float phi) {
    const float s = std::sqrt((1 - mu) * (1 + mu));
    return Vec3(s * std::cos(phi), s * std::sin(phi), mu);
}
constexpr float cosines[] = {0.95f, 0.5f, 0.15f, -0.3f, -0.8f};

BsdfSample draw(const Material& m, Vec3 wo, test::Random& random) {
    const Vec2 u = random.square();
    return sample_bsdf<feature::all>(m, m.reflectance, wo, random.u(), u);
}
BsdfValue value(const Material& m, Vec3 wo, Vec3 wi) {
    return evaluate_bsdf<feature::all>(m, m.reflectance, wo, wi);
}

// f |cos_i|, red, as the papers write it, in double.
double textbook(const Material& m, DVec3 wo, DVec3 wi) {
    const bool reflects = wo.z * wi.z > 0;
    const double alpha2 = double(m.alpha) * m.alpha;
    const auto D = [&](DVec3 h) {
        const double tan2 = (h.x * h.x + h.y * h.y) / (h.z * h.z);
        const double scale = M_PI * alpha2 * std::pow(h.z, 4);
        return m.microfacets == Microfacets::ggx ? 1 / (scale * std::pow(1 + tan2 / alpha2, 2))
                                                 : std::exp(-tan2 / alpha2) / scale;
    };
    const auto G1 = [&](DVec3 w, DVec3 h) {
        if (dot(w, h) * w.z <= 0) return 0.0;
        const double tan = std::sqrt(w.x * w.x + w.y * w.y) / std::abs(w.z);
        const double a = 1 / (m.alpha * tan);
        const double lambda =
            m.microfacets == Microfacets::ggx
                ? (std::sqrt(1 + 1 / (a * a)) - 1) / 2
                : (std::erf(a) - 1) / 2 + std::exp(-a * a) / (2 * a * std::sqrt(M_PI));
        return 1 / (1 + lambda);
    };
    switch (m.kind) {
    case MaterialKind::diffuse:
        return reflects ? m.reflectance.x / M_PI * std::abs(wi.z) : 0;
    case MaterialKind::phong: {
        if (!reflects) return 0;
        const double cos_alpha = dot(wi, DVec3(-wo.x, -wo.y, wo.z));
        const double lobe =
            (m.exponent + 2) / (2 * M_PI) * (cos_alpha > 0 ? std::pow(cos_alpha, m.exponent) : 0.0);
        return (m.reflectance.x / M_PI + m.specular.x * lobe) * std::abs(wi.z);
    }
    case MaterialKind::conductor: { // Torrance and Sparrow
        if (!reflects) return 0;
        DVec3 h = glm::normalize(wo + wi);
        const double F = conductor_reflectance(m, std::abs(dot(wo, h))).x;
        if (wo.z < 0) h = -h;
        return m.reflectance.x * F * D(h) * G1(wo, h) * G1(wi, h) / (4 * std::abs(wo.z));
    }
    case MaterialKind::rough_dielectric: { // Walter et al., eqs. 20 and 21
        const double n_o = wo.z > 0 ? 1 : m.ior, n_i = wi.z > 0 ? 1 : m.ior;
        DVec3 h = glm::normalize(reflects ? wo + wi : n_o * wo + n_i * wi);
        if (h.z < 0) h = -h;
        const double oh = dot(wo, h), ih = dot(wi, h);
        const double F = dielectric_reflectance(m, std::abs(oh), wo.z > 0 ? m.ior : 1 / m.ior);
        const double DG = D(h) * G1(wo, h) * G1(wi, h);
        if (reflects) return m.reflectance.x * F * DG / (4 * std::abs(wo.z));
        // The paper's f is for radiance; basic radiance L / n^2 multiplies it by n_i^2 / n_o^2.
        const double jacobian = n_o * n_o / std::pow(n_i * ih + n_o * oh, 2);
        return m.reflectance.x * (1 - F) * DG * std::abs(oh * ih) * jacobian / std::abs(wo.z) *
               (n_i * n_i) / (n_o * n_o);
    }
    default:
        return 0;
    }
}

// Cells of the sphere, uniform in z and phi, and integrals over each by 10 x 10 midpoints (long:
// 40).
constexpr int rows = 40, columns = 64;
int cell_of(Vec3 w) {
    const double turn = std::atan2(double(w.y), double(w.x)) / (2 * M_PI);
    const int column = int((turn - std::floor(turn)) * columns);
    return std::clamp(int((w.z + 1) / 2 * rows), 0, rows - 1) * columns +
           std::min(column, columns - 1);
}
std::vector<double> integrate_cells(const std::function<double(Vec3)>& f) {
    std::vector<double> cells(rows * columns);
    const int n = test::count(10, 40);
    for (int i = 0; i < rows * n; ++i)
        for (int k = 0; k < columns * n; ++k) {
            const double z = 2 * (i + 0.5) / (rows * n) - 1, r = std::sqrt(1 - z * z);
            const double phi = 2 * M_PI * (k + 0.5) / (columns * n);
            cells[i / n * columns + k / n] += f(Vec3(r * std::cos(phi), r * std::sin(phi), z));
        }
    for (double& c : cells) c *= 4 * M_PI / (rows * columns * n * n);
    return cells;
}
double sum(const std::vector<double>& v) {
    double s = 0;
    for (double x : v) s += x;
    return s;
}

// For each case and direction: the histogram of samples against the integrals of pdf (chi-square,
// false alarm 1e-5 each, 6e-4 for all 60), the part of valid samples against the whole integral,
// and the mean weight against the integral of f cos (4 standard errors, 6e-5 each, plus 2e-3 for
// the quadrature).
TEST(Bsdf, samples_follow_the_density_and_their_mean_weight_is_the_albedo) {
    const int n = test::count(40'000, 400'000);
    for (const Case& c : all_cases())
        for (const float mu : cosines) {
            SCOPED_TRACE(testing::Message() << c.name << " mu " << mu);
            const Vec3 wo = at(mu, 0.7f);
            test::Random random(11);
            std::vector<double> histogram(rows * columns);
            test::Mean valid, weight;
            for (int i = 0; i < n; ++i) {
                const BsdfSample s = draw(c.material, wo, random);
                valid.add(s.valid);
                weight.add(s.valid ? s.weight.x : 0);
                if (s.valid) ++histogram[cell_of(s.wi)];
            }
            std::vector<double> expected =
                integrate_cells([&](Vec3 wi) { return value(c.material, wo, wi).pdf; });
            const double whole = sum(expected);
            EXPECT_NEAR(valid.mean(), whole, 4 * valid.standard_error() + 2e-3);
            EXPECT_LE(whole, 1 + 2e-3);
            for (double& e : expected) e *= n * valid.mean() / whole;
            EXPECT_GT(test::chi_square_p(histogram, expected), 1e-5);

            const double albedo =
                sum(integrate_cells([&](Vec3 wi) { return value(c.material, wo, wi).f_cos.x; }));
            EXPECT_NEAR(weight.mean(), albedo, 4 * weight.standard_error() + 2e-3);
            EXPECT_LE(weight.mean(), 1 + 4 * weight.standard_error()) << "makes light";
        }
}

TEST(Bsdf, the_chi_square_test_sees_a_wrong_density) {
    const Material lobe = phong(50, Vec3(0), Vec3(0.9f)), wrong = phong(55, Vec3(0), Vec3(0.9f));
    const Vec3 wo = at(0.5f, 0.7f);
    test::Random random(11);
    std::vector<double> histogram(rows * columns);
    const int n = 40'000;
    for (int i = 0; i < n; ++i) {
        const BsdfSample s = draw(lobe, wo, random);
        if (s.valid) ++histogram[cell_of(s.wi)];
    }
    std::vector<double> expected =
        integrate_cells([&](Vec3 wi) { return value(wrong, wo, wi).pdf; });
    const double scale = sum(histogram) / sum(expected);
    for (double& e : expected) e *= scale;
    EXPECT_LT(test::chi_square_p(histogram, expected), 1e-5);
}

TEST(Bsdf, weight_is_f_cos_over_pdf_and_f_is_the_textbooks) {
    double worst_weight = 0, worst_f = 0;
    for (const Case& c : all_cases())
        for (const float mu : cosines) {
            SCOPED_TRACE(testing::Message() << c.name << " mu " << mu);
            const Vec3 wo = at(mu, 0.7f);
            test::Random random(5);
            for (int i = 0; i < 2000; ++i) {
                const BsdfSample s = draw(c.material, wo, random);
                if (!s.valid || std::abs(s.wi.z) < 1e-3f) continue; // there cos has no digits left
                ASSERT_FALSE(s.specular);
                ASSERT_NEAR(length(s.wi), 1, 1e-6);
                const BsdfValue v = value(c.material, wo, s.wi);
                ASSERT_GT(v.pdf, 0);
                ASSERT_NEAR(v.pdf / s.pdf, 1, 1e-3);
                const Vec3 ratio = v.f_cos / v.pdf;
                for (int k = 0; k < 3; ++k) {
                    const double error = std::abs(ratio[k] - s.weight[k]);
                    ASSERT_LE(error, 1e-3 * s.weight[k]);
                    worst_weight = std::max(worst_weight, error);
                }
                const double truth = textbook(c.material, DVec3(wo), DVec3(s.wi));
                ASSERT_NEAR(v.f_cos.x / truth, 1, 5e-4);
                worst_f = std::max(worst_f, std::abs(v.f_cos.x / truth - 1));
            }
        }
    RecordProperty("weight_error", std::to_string(worst_weight));
    RecordProperty("f_error", std::to_string(worst_f));
}

// f(wo, wi) = f(wi, wo); for basic radiance across an interface f(wo, wi) / n_i^2 = f(wi, wo) /
// n_o^2.
TEST(Bsdf, is_reciprocal) {
    for (const Case& c : all_cases()) {
        SCOPED_TRACE(c.name);
        test::Random random(6);
        int compared = 0;
        for (int i = 0; i < 20'000; ++i) {
            const Vec3 wo = random.direction(), wi = random.direction();
            if (std::min(std::abs(wo.z), std::abs(wi.z)) < 0.01f) continue;
            const float there = value(c.material, wo, wi).f_cos.x / std::abs(wi.z);
            const float back = value(c.material, wi, wo).f_cos.x / std::abs(wo.z);
            const bool dielectric = c.material.kind == MaterialKind::rough_dielectric;
            const float n_i = dielectric && wi.z < 0 ? c.material.ior : 1;
            const float n_o = dielectric && wo.z < 0 ? c.material.ior : 1;
            compared += there > 1e-3f;
            // Where F is near 1 its rounding is a large part of 1 - F: the absolute tolerance.
            const float expected = back * n_i * n_i / (n_o * n_o);
            ASSERT_NEAR(there, expected, 1e-3 * expected + 1e-5) << "wo.z " << wo.z;
        }
        EXPECT_GT(compared, 1000);
    }
}

TEST(Bsdf, opaque_materials_are_the_same_from_both_sides) {
    const Vec3 flip(1, 1, -1);
    for (const Case& c : all_cases()) {
        if (c.material.kind == MaterialKind::rough_dielectric) continue;
        const Vec3 wo = at(0.4f, 1);
        const BsdfSample a =
            sample_bsdf<feature::all>(c.material, Vec3(1), wo, 0.2f, Vec2(0.3f, 0.6f));
        const BsdfSample b =
            sample_bsdf<feature::all>(c.material, Vec3(1), wo * flip, 0.2f, Vec2(0.3f, 0.6f));
        EXPECT_EQ(a.wi * flip, b.wi) << c.name;
        EXPECT_EQ(a.weight, b.weight) << c.name;
        EXPECT_EQ(a.pdf, b.pdf) << c.name;
        EXPECT_EQ(value(c.material, wo, a.wi).pdf, value(c.material, wo * flip, b.wi).pdf)
            << c.name;
        EXPECT_EQ(value(c.material, wo, a.wi * flip).pdf, 0) << c.name << " lets light through";
    }
}

// U-EDGE: whatever the numbers, a sample is finite and unit, or rejected.
TEST(UEdge, every_bsdf) {
    std::vector<Case> cases = all_cases();
    cases.push_back({"mirror", make(MaterialKind::mirror)});
    cases.push_back({"glass", make(MaterialKind::glass)});
    constexpr float edges[] = {0, 0x1p-32f, 0x1p-24f, 0.5f, 1 - 0x1p-24f, 1};
    for (const Case& c : cases)
        for (const float mu : {1.0f, 0.5f, 1e-4f, 1e-7f, 0.0f, -1e-7f, -0.7f, -1.0f}) {
            int valid = 0;
            for (const float lobe : edges)
                for (const float x : edges)
                    for (const float y : edges) {
                        SCOPED_TRACE(testing::Message() << c.name << " mu " << mu << " u " << lobe
                                                        << " " << x << " " << y);
                        const BsdfSample s = sample_bsdf<feature::all>(
                            c.material, c.material.reflectance, at(mu, 2), lobe, Vec2(x, y));
                        if (!s.valid) continue;
                        ++valid;
                        ASSERT_NEAR(length(s.wi), 1, 2e-6);
                        ASSERT_TRUE(is_finite(s.weight) && s.weight.x >= 0);
                        ASSERT_TRUE(std::isfinite(s.pdf) && (s.pdf > 0) != s.specular) << s.pdf;
                    }
            EXPECT_GE(valid, mu == 0 ? 0 : 20) << c.name << " mu " << mu;
        }
}

TEST(Glass, reflects_in_proportion_to_fresnel_and_keeps_all_light) {
    const Material glass = make(MaterialKind::glass);
    for (const float mu : {1.0f, 0.6f, 0.1f, -0.1f, -0.9f}) {
        const Vec3 wo = at(mu, 0.4f);
        const double F = fresnel_split(glass, wo).reflectance;
        const int n = 10'000;
        int reflected = 0;
        for (int i = 0; i < n; ++i) {
            const BsdfSample s =
                sample_bsdf<feature::all>(glass, Vec3(0.9f), wo, (i + 0.5f) / n, Vec2(0));
            ASSERT_TRUE(s.valid && s.specular && s.pdf == 0);
            ASSERT_EQ(s.weight, Vec3(0.9f));
            reflected += s.wi.z * wo.z > 0;
        }
        EXPECT_NEAR(reflected / double(n), F, 1.0 / n) << mu;
    }
    EXPECT_EQ(value(glass, at(0.5f, 0), at(-0.7f, 3)).pdf, 0);
}

TEST(Glass, a_rough_interface_becomes_smooth_below_1e_minus_3_and_between_equal_indices) {
    Material m = microfacet(MaterialKind::rough_dielectric, Microfacets::ggx, 0.5e-3f);
    EXPECT_TRUE(is_specular<feature::all>(m));
    m.alpha = 0.3f;
    EXPECT_FALSE(is_specular<feature::all>(m));
    m.ior = 1;
    EXPECT_TRUE(is_specular<feature::all>(m));
    const Vec3 wo = at(0.5f, 1);
    const BsdfSample s = sample_bsdf<feature::all>(m, Vec3(1), wo, 0, Vec2(0.2f, 0.3f));
    EXPECT_NEAR(length(s.wi + wo), 0, 1e-6) << "straight on";
}

TEST(Bsdf, a_kernel_has_only_the_kinds_it_was_compiled_for) {
    const Material mirror = make(MaterialKind::mirror), diffuse = make(MaterialKind::diffuse);
    const Vec3 wo = at(0.5f, 1);
    EXPECT_FALSE(sample_bsdf<variant::matte>(mirror, Vec3(1), wo, 0, Vec2(0.5f)).valid);
    EXPECT_TRUE(sample_bsdf<variant::classic>(mirror, Vec3(1), wo, 0, Vec2(0.5f)).valid);
    EXPECT_TRUE(sample_bsdf<variant::matte>(diffuse, Vec3(1), wo, 0, Vec2(0.5f)).valid);
    EXPECT_TRUE(is_specular<feature::all>(mirror));
    EXPECT_FALSE(is_specular<feature::all>(diffuse));
}

} // namespace
} // namespace raylab
