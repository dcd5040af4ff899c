// GGX-FURN, PHONG-ALB: how bright is a white rough surface in a white world?
//
// Its directional albedo, the integral of f cos over the hemisphere, seen in a render under a sky
// of radiance 1. Truth by quadrature in double, over mappings of the test's own.
#include "app/tests/accuracy.h"

namespace raylab::app {

namespace {

constexpr int grid = 500; // midpoints a side

template <class Weight> double mean_over_square(const Weight& weight) {
    double sum = 0;
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) sum += weight((i + 0.5) / grid, 2 * M_PI * (j + 0.5) / grid);
    return sum / (grid * grid);
}

// Smith's masking of GGX: 2 / (1 + sqrt(1 + alpha^2 tan^2)).
double masking(double cosine, double alpha) {
    const double tan2 = 1 / (cosine * cosine) - 1;
    return 2 / (1 + std::sqrt(1 + alpha * alpha * tan2));
}

// Normals m in proportion to D(m) m.z, tan^2 = alpha^2 u / (1 - u): the albedo is the mean of
// G1(wo) G1(wi) (wo.m) / (mu m.z) over them. Without masking (naive) G1 = 1.
double ggx_albedo(double mu, double alpha, bool masked = true) {
    const DVec3 wo(std::sqrt(1 - mu * mu), 0, mu);
    return mean_over_square([&](double u, double phi) {
        // u = 1 - (1 - v)^2 puts more points where normals are steep.
        const double v = 1 - (1 - u) * (1 - u), tan2 = alpha * alpha * v / (1 - v);
        const double z = 1 / std::sqrt(1 + tan2), r = std::sqrt(1 - z * z);
        const DVec3 m(r * std::cos(phi), r * std::sin(phi), z);
        const double cosine = dot(wo, m), out = 2 * cosine * z - mu;
        if (cosine <= 0 || out <= 0) return 0.0;
        const double g = masked ? masking(mu, alpha) * masking(out, alpha) : 1;
        return 2 * (1 - u) * g * cosine / (mu * z);
    });
}

// Directions around the mirrored one with cos(a) = u^(1 / (n + 1)); the lobe's factor is n + 2, its
// density n + 1. unnormalised: the factor n + 1, the naive variant.
double phong_albedo(double mu, double n, bool unnormalised = false) {
    const DVec3 mirrored(-std::sqrt(1 - mu * mu), 0, mu);
    const DVec3 x(mu, 0, std::sqrt(1 - mu * mu)), y(0, 1, 0);
    return (unnormalised ? 1 : (n + 2) / (n + 1)) * mean_over_square([&](double u, double phi) {
               const double c = std::pow(u, 1 / (n + 1)), s = std::sqrt(1 - c * c);
               const DVec3 wi = s * std::cos(phi) * x + s * std::sin(phi) * y + c * mirrored;
               return std::max(0.0, wi.z);
           });
}

// A square of the material, seen under the cosine mu by a camera of a very narrow field of view.
Estimate render(const std::string& lab, const std::string& material, double mu,
                const std::string& strategy, int spp) {
    const Scene scene =
        parse({.camera = camera(10.0 * DVec3(std::sqrt(1 - mu * mu), 0, mu), {0, 0, 0}, 1e-3),
               .materials = R"("m": )" + material,
               .shapes = quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, "m"),
               .lights = white_sky,
               .render = R"("max_depth": 2, "sampler": "independent", "direct_light": ")" +
                         strategy + '"',
               .width = 32,
               .height = 32});
    return estimate(trace(lab, scene, spp).film);
}

void compare(const char* row, const std::string& lab, const std::string& what, Estimate found,
             double truth, double bias, std::optional<double> naive = {}) {
    figure(row, lab, fmt::format("{}: {:.5f}, found {:.5f}", what, truth, found.mean),
           std::fabs(found.mean - truth), bias + 4 * found.error,
           naive ? std::optional(std::fabs(*naive - truth)) : std::nullopt);
}

TEST(GgxFurn, TheQuadratureKnowsTheClosedForm) {
    EXPECT_NEAR(ggx_albedo(1, 1), 1 - std::log(2.0), 2e-5);
}

// Two clamped cosines an angle g apart overlap by 2/3 (sin g + (pi - g) cos g); n = 1 counts 3 / 2
// pi.
TEST(PhongAlb, TheQuadratureKnowsTheClosedForm) {
    for (const double mu : {1.0, 0.5, 0.1}) {
        const double g = std::acos(mu);
        EXPECT_NEAR(phong_albedo(mu, 1), (std::sin(g) + (M_PI - g) * mu) / M_PI, 5e-5);
    }
}

TEST_P(EachLab, GgxFurnWhiteMetalIsAsBrightAsMaskingLeavesIt) {
    for (const double alpha : {0.01, 0.1, 0.5, 1.0})
        for (const double mu : {1.0, 0.5, 0.1, 0.01}) {
            const std::string metal = fmt::format(
                R"({{"kind": "conductor", "eta": [1, 1, 1], "k": [1e4, 1e4, 1e4], "alpha": {}}})",
                alpha);
            const double truth = ggx_albedo(mu, alpha), naive = ggx_albedo(mu, alpha, false);
            const std::string what = fmt::format("alpha {}, mu {}", alpha, mu);
            const bool masks = std::fabs(naive - truth) > 0.01;
            const Estimate found = render(GetParam(), metal, mu, "bsdf", count(16, 512));
            compare("GGX-FURN", GetParam(), what, found, truth, 5e-4,
                    masks ? std::optional(naive) : std::nullopt);
            EXPECT_LE(found.mean, 1 + 1e-6);
            if (alpha >= 0.5) // narrower lobes are too noisy where the sky is sampled
                compare("GGX-FURN", GetParam(), what + ", MIS",
                        render(GetParam(), metal, mu, "mis", count(16, 512)), truth, 5e-4);
        }
}

TEST_P(EachLab, PhongAlbIsTheLobeLessWhatTheSurfaceCutsOff) {
    for (const double n : {1.0, 10.0, 100.0, 1000.0})
        for (const double mu : {1.0, 0.5, 0.1}) {
            const std::string lobe = fmt::format(
                R"({{"kind": "phong", "reflectance": [0, 0, 0], "specular": [1, 1, 1], "exponent": {}}})",
                n);
            const double truth = phong_albedo(mu, n), naive = phong_albedo(mu, n, true);
            const std::string what = fmt::format("n = {}, mu {}", n, mu);
            compare("PHONG-ALB", GetParam(), what,
                    render(GetParam(), lobe, mu, "bsdf", count(16, 512)), truth, 1e-3,
                    n < 10 ? std::optional(naive) : std::nullopt);
            if (n <= 10)
                compare("PHONG-ALB", GetParam(), what + ", MIS",
                        render(GetParam(), lobe, mu, "mis", count(16, 512)), truth, 1e-3);
        }
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
