// Shading around a tilted normal: no direction passes an opaque face, no energy is lost, samples
// follow the density, and a flat face keeps its bits.
#include "common/geometry/shading_normal.h"
#include "common/sampling/tests/statistics.h"
#include "common/transport/scatter.h"
#include "common/transport/specular_split.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>

namespace raylab {
namespace {

constexpr Features F = feature::all;

// A face whose normal ng is turned, so that nothing is along an axis, and a normal tilted by
// `degrees` towards some side of it.
SurfacePoint face_with_normal(Vec3 ng, float degrees, Vec3 towards, Vec3 wo) {
    SurfacePoint surface{};
    surface.ng = ng;
    const Vec3 aside = normalize(towards - dot(towards, ng) * ng);
    const float a = degrees * pi / 180;
    const Vec3 n = normalize(std::cos(a) * ng + std::sin(a) * aside);
    surface.shading = Frame::around(facing_normal(degrees == 0 ? ng : n, ng, wo));
    return surface;
}

float sign(float x) { return std::copysign(1.0f, x); }

// --- facing_normal ----------------------------------------------------------------------------

// Of any unit vectors: the sides agree, and the result stays on ng's side; where wo sees n well, no
// bit changes.
TEST(FacingNormal, sees_wo_from_the_side_of_the_face) {
    test::Random random(3);
    for (int i = 0; i < test::count(300'000, 10'000'000); ++i) {
        const Vec3 ng = random.direction();
        Vec3 n = random.direction(), wo = random.direction();
        if (i % 3 == 1) // grazing the face, down to rounding
            wo = normalize(wo + (std::pow(10.0f, random.between(-9, 0)) - dot(wo, ng)) * ng);
        if (i % 3 == 2) // n nearly opposite to wo
            n = normalize(-wo + std::pow(10.0f, random.between(-9, 0)) * n);
        if (!(dot(n, ng) > 0)) n = -n;
        if (!(dot(n, ng) > 0) || dot(wo, ng) == 0) continue;
        const Vec3 facing = facing_normal(n, ng, wo);
        ASSERT_GT(dot(wo, facing) * sign(dot(wo, ng)), 0) << i;
        ASSERT_GT(dot(facing, ng), 0) << i;
        ASSERT_NEAR(length(facing), 1, 1e-6) << i;
        const bool is_seen_well = dot(wo, n) * sign(dot(wo, ng)) >= 0x1p-10f;
        ASSERT_TRUE(!is_seen_well || facing == n) << i;
    }
}

// A small step of wo is a small step of n', also across the place where bending begins.
TEST(FacingNormal, is_continuous_in_wo) {
    const Vec3 ng(0, 0, 1), n = normalize(Vec3(2, 0, 1));
    Vec3 last = n;
    float turned = 0;
    for (int i = 0; i < 20000; ++i) {
        const float a = pi / 2 * i / 20000;
        const Vec3 facing = facing_normal(n, ng, Vec3(-std::sin(a), 0, std::cos(a)));
        ASSERT_LT(length(facing - last), 3e-3f) << i;
        turned += length(facing - last);
        last = facing;
    }
    // In the end wo lies in the face: n' is ng, 63.4 degrees from n.
    EXPECT_NEAR(turned, std::atan(2.0), 2e-2);
}

TEST(FacingNormal, interpolation_has_an_answer_for_what_is_no_normal) {
    const Vec3 ng(0, 0, 1), b(0.25f, 0.25f, 0.5f), nan(std::nanf(""));
    const Vec3 cancels[3] = {{1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
    const Vec3 underflows[3] = {{1, 0, 1e-25f}, {1, 0, 1e-25f}, {-1, 0, 1e-25f}};
    const Vec3 infinite[3] = {Vec3(infinity), Vec3(0, 0, 1), Vec3(0, 0, 1)};
    const Vec3 overflows[3] = {Vec3(0, 0, 3e38f), Vec3(0, 0, 3e38f), Vec3(0, 0, 3e38f)};
    const Vec3 unknown[3] = {nan, nan, nan};
    for (const auto* normals : {&cancels, &underflows, &infinite, &overflows, &unknown})
        EXPECT_EQ(interpolated_normal(*normals, b, ng), ng);
}

// --- The fold ---------------------------------------------------------------------------------

// Whatever rounding does, down to grazing: what is above n comes out above the face.
TEST(Fold, keeps_the_side) {
    test::Random random(5);
    int folded = 0;
    for (int i = 0; i < test::count(300'000, 10'000'000); ++i) {
        const SurfacePoint surface =
            face_with_normal(random.direction(), i % 4 == 0 ? 0 : random.between(0, 89.9f),
                             random.direction(), random.direction());
        Vec3 w = random.direction();
        if (i % 2 == 0)
            w = normalize(Vec3(w.x, w.y, sign(w.z) * std::pow(10.0f, random.between(-12, 0))));
        const Vec3 world = fold_to_world(surface, w);
        ASSERT_GT(w.z * dot(world, surface.ng), 0) << i;
        ASSERT_NEAR(length(world), 1, 1e-6) << i;
        folded += length(world - surface.shading.to_world(w)) > 1e-5f;
    }
    EXPECT_GT(folded, 10'000);
}

TEST(Fold, does_nothing_to_a_flat_face) {
    test::Random random(6);
    const Material m;
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 ng = random.direction(), wo = random.direction(), wi = random.direction();
        const SurfacePoint surface = face_with_normal(ng, 0, wo, wo);
        const Frame& frame = surface.shading;
        ASSERT_EQ(frame.z, ng);
        const Vec3 u(random.u(), random.u(), random.u());
        BsdfSample plain = sample_bsdf<F>(m, Vec3(0.5f), frame.to_local(wo), u.x, Vec2(u.y, u.z));
        plain.wi = frame.to_world(plain.wi);
        const BsdfSample folded = sample_bsdf<F>(surface, m, Vec3(0.5f), wo, u.x, Vec2(u.y, u.z));
        ASSERT_EQ(std::memcmp(&plain.wi, &folded.wi, sizeof plain.wi), 0);
        ASSERT_EQ(plain.pdf, folded.pdf);
        const BsdfValue a = evaluate_bsdf<F>(m, Vec3(0.5f), frame.to_local(wo), frame.to_local(wi));
        const BsdfValue b = evaluate_bsdf<F>(surface, m, Vec3(0.5f), wo, wi);
        ASSERT_EQ(a.f_cos, b.f_cos);
        ASSERT_EQ(a.pdf, b.pdf);
    }
}

// Mirrors and glass: one direction in, one out, on its side.
TEST(Fold, splits_stay_on_their_sides) {
    test::Random random(7);
    Material glass, mirror;
    glass.kind = MaterialKind::glass, mirror.kind = MaterialKind::mirror;
    for (int i = 0; i < 100'000; ++i) {
        const Vec3 wo = random.direction();
        const SurfacePoint surface =
            face_with_normal(random.direction(), random.between(0, 89), random.direction(), wo);
        const float side = sign(dot(wo, surface.ng));
        const SpecularSplit split = split_specular<F>(surface, glass, Vec3(1), wo);
        ASSERT_GT(side * dot(split.reflected, surface.ng), 0);
        ASSERT_TRUE(!split.refracts || side * dot(split.refracted, surface.ng) < 0);
        const SpecularSplit reflection = split_specular<F>(surface, mirror, Vec3(1), wo);
        ASSERT_GT(side * dot(reflection.reflected, surface.ng), 0);
    }
}

// --- Density and energy -----------------------------------------------------------------------

struct Case {
    std::string name;
    Material material;
};

std::vector<Case> materials() {
    Material diffuse, phong, metal, glass;
    diffuse.reflectance = Vec3(0.8f);
    phong.kind = MaterialKind::phong;
    phong.exponent = 20, phong.reflectance = Vec3(0.3f), phong.specular = Vec3(0.5f);
    metal.kind = MaterialKind::conductor;
    metal.alpha = 0.4f, metal.eta = Vec3(0.143f), metal.k = Vec3(3.983f),
    metal.reflectance = Vec3(1);
    glass.kind = MaterialKind::rough_dielectric;
    glass.alpha = 0.3f, glass.reflectance = Vec3(1);
    return {{"diffuse", diffuse}, {"phong", phong}, {"metal", metal}, {"glass", glass}};
}

// Cells of the sphere, uniform in z and turn, and integrals over each by midpoints.
constexpr int rows = 12, columns = 18;
int cell_of(Vec3 w) {
    const double turn = std::atan2(double(w.y), double(w.x)) / (2 * M_PI);
    const int row = std::min(int((w.z + 1) / 2 * rows), rows - 1);
    return row * columns + std::min(int((turn - std::floor(turn)) * columns), columns - 1);
}
std::vector<double> integrate_cells(const std::function<double(Vec3)>& f) {
    std::vector<double> cells(rows * columns);
    const int n = test::count(36, 120);
    for (int i = 0; i < rows * n; ++i)
        for (int k = 0; k < columns * n; ++k) {
            const double z = 2 * (i + 0.5) / (rows * n) - 1, r = std::sqrt(1 - z * z);
            const double turn = 2 * M_PI * (k + 0.5) / (columns * n);
            cells[i / n * columns + k / n] += f(Vec3(r * std::cos(turn), r * std::sin(turn), z)) *
                                              4 * M_PI / (rows * columns * n * n);
        }
    return cells;
}
double sum(const std::vector<double>& v) {
    double s = 0;
    for (const double x : v) s += x;
    return s;
}

// For each material, tilt and wo, the last of which the normal has to be bent for: the histogram of
// samples against the integrals of pdf' (chi-square, false alarm 1e-6 each, 4e-5 for all 36), its
// whole against the part of samples that are valid, the integral of f' against that of the BSDF
// alone and against the mean weight (4 standard errors, 6e-5 each, plus 4e-3 for the quadrature).
// Nothing opaque lies below the face.
TEST(Fold, samples_follow_the_density_and_no_energy_is_lost) {
    const int n = test::count(40'000, 400'000);
    const Vec3 ng(0, 0, 1);
    for (const Case& c : materials())
        for (const float degrees : {20.0f, 50.0f, 80.0f})
            for (const Vec3 wo :
                 {normalize(Vec3(0.5f, 0.3f, 0.6f)), normalize(Vec3(-0.4f, 0.7f, -0.5f)),
                  normalize(Vec3(-0.9f, -0.1f, 0.15f))}) {
                SCOPED_TRACE(testing::Message()
                             << c.name << " tilted " << degrees << ", wo.z " << wo.z);
                const SurfacePoint surface = face_with_normal(ng, degrees, Vec3(1, 0.2f, 0), wo);
                const Material& m = c.material;
                test::Random random(11);
                std::vector<double> histogram(rows * columns);
                test::Mean valid, weight;
                for (int i = 0; i < n; ++i) {
                    const Vec2 u = random.square();
                    const BsdfSample s =
                        sample_bsdf<F>(surface, m, m.reflectance, wo, random.u(), u);
                    valid.add(s.valid);
                    weight.add(s.valid ? s.weight.x : 0);
                    if (!s.valid) continue;
                    ++histogram[cell_of(s.wi)];
                    // Drawn or evaluated, a direction has one density.
                    const float pdf = evaluate_bsdf<F>(surface, m, m.reflectance, wo, s.wi).pdf;
                    ASSERT_NEAR(s.pdf / pdf, 1, 2e-3);
                }
                std::vector<double> expected = integrate_cells([&](Vec3 wi) {
                    return evaluate_bsdf<F>(surface, m, m.reflectance, wo, wi).pdf;
                });
                const double whole = sum(expected);
                EXPECT_NEAR(valid.mean(), whole, 4 * valid.standard_error() + 4e-3);
                for (double& e : expected) e *= n * valid.mean() / whole;
                EXPECT_GT(test::chi_square_p(histogram, expected), 1e-6);

                const std::vector<double> energy = integrate_cells([&](Vec3 wi) {
                    return evaluate_bsdf<F>(surface, m, m.reflectance, wo, wi).f_cos.x;
                });
                const Vec3 local = surface.shading.to_local(wo);
                const double unfolded = sum(integrate_cells([&](Vec3 wi) {
                    return evaluate_bsdf<F>(m, m.reflectance, local, wi).f_cos.x;
                }));
                EXPECT_NEAR(sum(energy), unfolded, 4e-3);
                EXPECT_NEAR(weight.mean(), unfolded, 4 * weight.standard_error() + 4e-3);
                if (m.kind == MaterialKind::rough_dielectric) continue;
                for (int cell = 0; cell < rows * columns; ++cell)
                    EXPECT_TRUE(energy[cell] == 0 || (cell < rows / 2 * columns) != (wo.z > 0));
            }
}

} // namespace
} // namespace raylab
