// Mappings of the square: U-EDGE, and the density that each promises.
#include "common/sampling/tests/statistics.h"
#include "common/sampling/warp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace raylab {
namespace {

constexpr float edges[] = {0, 0x1p-32f, 0x1p-24f, 0.5f, 1 - 0x1p-24f, 1};

void for_each_edge(const std::function<void(Vec2)>& check) {
    for (const float x : edges)
        for (const float y : edges) {
            SCOPED_TRACE(testing::Message() << "u = (" << x << ", " << y << ")");
            check(Vec2(x, y));
        }
}

TEST(UEdge, every_mapping_is_finite_unit_and_in_its_domain) {
    for_each_edge([](Vec2 u) {
        EXPECT_LE(glm::length(sample_disk(u)), 1 + 1e-6f);
        const Vec3 hemisphere = sample_cosine_hemisphere(u);
        EXPECT_NEAR(length(hemisphere), 1, 1e-6);
        EXPECT_GE(hemisphere.z, 0);
        EXPECT_TRUE(cosine_hemisphere_pdf(hemisphere.z) > 0 || u.x == 1 || u.y == 1);
        EXPECT_NEAR(length(sample_uniform_sphere(u)), 1, 1e-6);
        const Vec2 b = sample_triangle(u);
        EXPECT_TRUE(b.x >= 0 && b.y >= 0 && b.x + b.y <= 1);
        for (const float sin2 : {1.0f, 0.25f, 1e-6f, 1e-14f, 1e-30f}) {
            const float size = one_minus_cos(sin2);
            const Vec3 d = sample_cone(u, size);
            EXPECT_NEAR(length(d), 1, 1e-6);
            EXPECT_LE(length_squared(d) - d.z * d.z, sin2 * 1.000001f + 1e-7f);
            EXPECT_TRUE(cone_pdf(size) > 0 && std::isfinite(cone_pdf(size)));
        }
        for (const float a : {0.0f, 1e-30f, 1.0f, 1e30f})
            for (const float b : {1e-30f, 1.0f}) {
                const float x = sample_linear(u.x, a, b);
                EXPECT_TRUE(x >= 0 && x <= 1) << a << " " << b << " " << x;
            }
    });
}

TEST(UEdge, a_hemisphere_without_cell_centres_would_touch_the_horizon) {
    // What the shift by half a cell is for: u = 0 gives a direction in the surface, density 0.
    const float a = 2 * 0.0f - 1;
    EXPECT_EQ(std::sqrt(1 - a * a), 0);
    EXPECT_GT(sample_cosine_hemisphere(Vec2(0, 0)).z, 3e-4f);
}

TEST(Circle, cosine_and_sine_of_a_turn) {
    double worst = 0;
    for (int i = -200000; i <= 200000; ++i) {
        const float u = i * 5e-6f;
        const Vec2 p = cos_sin_turn(u);
        worst = std::max({worst, std::abs(p.x - std::cos(2 * M_PI * u)),
                          std::abs(p.y - std::sin(2 * M_PI * u))});
    }
    EXPECT_LT(worst, 1.5e-7);
    EXPECT_EQ(cos_sin_turn(0.25f), Vec2(0, 1));
    EXPECT_EQ(cos_sin_turn(0.5f), Vec2(-1, 0));
    EXPECT_EQ(cos_sin_turn(0.75f), Vec2(0, -1));
}

TEST(OneMinusCos, is_exact_where_the_difference_has_no_digits) {
    double worst = 0, naive = 0;
    for (int k = 0; k <= 60; ++k) {
        const float sin2 = std::pow(10.0, -k / 4.0);
        const long double truth = sin2 / (1 + std::sqrt(1 - (long double)sin2));
        worst = std::max(worst, double(std::abs(one_minus_cos(sin2) / truth - 1)));
        naive = std::max(naive, double(std::abs((1 - std::sqrt(1 - sin2)) / truth - 1)));
    }
    EXPECT_LT(worst, 2e-7);
    EXPECT_GT(naive, 0.9) << "1 - cos should fail here";
}

// The p-value of samples mapped back to a 16 x 16 grid of cells that are equally likely.
double p_of(const std::function<Vec2(Vec2)>& sample_and_flatten, unsigned seed) {
    test::Random random(seed);
    std::vector<double> cells(256);
    for (int i = 0; i < test::count(200'000, 5'000'000); ++i) {
        const Vec2 v = sample_and_flatten(random.square());
        const auto cell = [](float x) { return std::clamp(int(x * 16), 0, 15); };
        ++cells[cell(v.x) * 16 + cell(v.y)];
    }
    return test::chi_square_uniform_p(cells);
}

float turn(float y, float x) { return float(std::atan2(double(y), double(x)) / (2 * M_PI) + 0.5); }

// False alarm 1e-4 for each of the six.
TEST(Warp, samples_follow_the_promised_density) {
    const auto disk = [](Vec2 u) {
        const Vec2 p = sample_disk(u);
        return Vec2(glm::dot(p, p), turn(p.y, p.x));
    };
    EXPECT_GT(p_of(disk, 1), 1e-4);
    const auto cosine = [](Vec2 u) { // P(sin^2 < s) = s
        const Vec3 d = sample_cosine_hemisphere(u);
        return Vec2(1 - d.z * d.z, turn(d.y, d.x));
    };
    EXPECT_GT(p_of(cosine, 7), 1e-4);
    const auto sphere = [](Vec2 u) {
        const Vec3 d = sample_uniform_sphere(u);
        return Vec2(0.5f - d.z / 2, turn(d.y, d.x));
    };
    EXPECT_GT(p_of(sphere, 3), 1e-4);
    const auto triangle = [](Vec2 u) { // P(b0 < t) = 1 - (1 - t)^2, b1 / (1 - b0) uniform
        const Vec2 b = sample_triangle(u);
        return Vec2(1 - (1 - b.x) * (1 - b.x), b.y / (1 - b.x));
    };
    EXPECT_GT(p_of(triangle, 4), 1e-4);
    const float size = one_minus_cos(1e-8f); // too narrow for 1 - d.z to have digits
    const auto cone = [&](Vec2 u) {
        const Vec3 d = sample_cone(u, size);
        return Vec2(one_minus_cos(d.x * d.x + d.y * d.y) / size, turn(d.y, d.x));
    };
    EXPECT_GT(p_of(cone, 5), 1e-4);
    const auto linear = [](Vec2 u) { // density (2 + 3x) 2/7: P(x < t) = (4 t + 3 t^2) / 7
        const float x = sample_linear(u.x, 2, 5);
        return Vec2((4 * x + 3 * x * x) / 7, u.y);
    };
    EXPECT_GT(p_of(linear, 6), 1e-4);

    // The classic mistakes: a disk with r = u, a hemisphere uniform in the angle.
    const auto clustered = [](Vec2 u) { return Vec2(u.x * u.x, u.y); };
    EXPECT_LT(p_of(clustered, 1), 1e-9);
    const auto angular = [](Vec2 u) { return Vec2(sqr(std::sin(u.x * pi / 2)), u.y); };
    EXPECT_LT(p_of(angular, 2), 1e-9);
}

TEST(Warp, a_uniform_linear_density_is_the_identity) {
    for (const float u : {0.0f, 0.1f, 0.5f, 0.75f, one_minus_epsilon})
        EXPECT_NEAR(sample_linear(u, 3, 3), u, 1.2e-7f);
}

} // namespace
} // namespace raylab
