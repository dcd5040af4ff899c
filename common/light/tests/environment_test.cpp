// Environment light: lookup, sampling in proportion to the map, poles and seam.
#include "common/light/tests/light_scene.h"
#include "common/sampling/tests/statistics.h"

#include <gtest/gtest.h>

namespace raylab {
namespace {

// A map with what is hard: bright texels at both poles and on both sides of the seam, black texels,
// a black row.
test::LightScene hard_map(int width = 16, int height = 9) {
    test::Random random(1);
    std::vector<Vec3> texels;
    for (int r = 0; r < height; ++r)
        for (int c = 0; c < width; ++c) {
            Vec3 L(random.u(), random.u(), random.u());
            if (c == 0 || c == width - 1) L *= 5.0f;
            if (r == 0 && c == 3) L = Vec3(200, 100, 50);
            if (r == height - 1 && c == 7) L = Vec3(50);
            if ((r + c) % 5 == 0 || r == 4) L = Vec3(0);
            texels.push_back(L);
        }
    test::LightScene scene;
    scene.add(width, height, texels);
    return scene;
}

TEST(Environment, directions_fall_into_the_texels_of_the_layout) {
    Environment e;
    e.width = 8, e.height = 4;
    const auto texel = [&](Vec3 d) {
        const Texel t = environment_texel(e, d);
        return std::pair(t.column, t.row);
    };
    using P = std::pair<int, int>;
    const float a = 0.1f; // past the texel's edge, in the direction of growing u
    EXPECT_EQ(texel(normalize(Vec3(1, 0.1f, a))), P(0, 1)) << "u = 0 is +x";
    EXPECT_EQ(texel(normalize(Vec3(-a, 0.1f, 1))), P(2, 1)) << "u = 1/4 is +z";
    EXPECT_EQ(texel(normalize(Vec3(-1, -0.1f, -a))), P(4, 2)) << "u = 1/2 is -x";
    EXPECT_EQ(texel(normalize(Vec3(a, 0.1f, -1))), P(6, 1)) << "u = 3/4 is -z";
    EXPECT_EQ(texel(normalize(Vec3(a, 1, a))).second, 0) << "row 0 is the top";
    EXPECT_EQ(texel(normalize(Vec3(a, -1, a))).second, 3);
}

TEST(Environment, poles_and_seam_are_in_the_map) {
    Environment e;
    e.width = 8, e.height = 4;
    for (const float x : {-1.0f, -1e-30f, -0.0f, 0.0f, 1e-30f, 1.0f})
        for (const float y : {-1.0f, -1e-30f, -0.0f, 0.0f, 1.0f})
            for (const float z : {-1.0f, -1e-30f, -0.0f, 0.0f, 1e-30f, 1.0f}) {
                const Texel t = environment_texel(e, Vec3(x, y, z));
                EXPECT_TRUE(t.column >= 0 && t.column < 8 && t.row >= 0 && t.row < 4)
                    << x << " " << y << " " << z;
            }
    EXPECT_EQ(environment_texel(e, Vec3(0, 1, 0)).row, 0);
    EXPECT_EQ(environment_texel(e, Vec3(0, -1, 0)).row, 3);
    EXPECT_EQ(environment_texel(e, Vec3(1, 0, -1e-30f)).column, 7) << "just below u = 1";
    EXPECT_EQ(environment_texel(e, Vec3(1, 0, 1e-30f)).column, 0);
}

TEST(Environment, every_direction_has_a_texel_even_one_that_is_no_number) {
    Environment e;
    e.width = 8, e.height = 4;
    const float values[] = {std::nanf(""), infinity, -infinity, 1e30f, -1e30f, 0.0f, -0.0f, 1.0f};
    for (const float x : values)
        for (const float y : values)
            for (const float z : values) {
                const Texel t = environment_texel(e, Vec3(x, y, z));
                EXPECT_TRUE(t.column >= 0 && t.column < 8 && t.row >= 0 && t.row < 4)
                    << x << " " << y << " " << z;
            }
}

TEST(Environment, solid_angles_of_the_texels_fill_the_sphere) {
    for (const int height : {1, 2, 9, 512, 4096}) {
        Environment e;
        e.width = 2 * height, e.height = height;
        double total = 0;
        for (int r = 0; r < height; ++r) {
            const double exact = 2 * M_PI / e.width *
                                 (std::cos(M_PI * r / height) - std::cos(M_PI * (r + 1) / height));
            EXPECT_NEAR(texel_solid_angle(e, r) / exact, 1, 1e-6) << r << " of " << height;
            total += double(texel_solid_angle(e, r)) * e.width;
        }
        EXPECT_NEAR(total, 4 * M_PI, 1e-5);
    }
}

// Histogram of the texels that sampled directions fall into, against luminance * sin(theta)
// (chi-square, false alarm 1e-4), and the agreement of both densities and radiances.
TEST(Environment, samples_follow_the_map) {
    const test::LightScene scene = hard_map();
    const SceneView view = scene.view();
    const Environment& e = view.environment;
    const int n = test::count(300'000, 10'000'000);
    std::vector<double> observed(e.width * e.height), expected(e.width * e.height);
    double total = 0;
    for (int r = 0; r < e.height; ++r)
        for (int c = 0; c < e.width; ++c) {
            double& x = expected[r * e.width + c];
            x = luminance(scene.map[r * e.width + c]) * std::sin(M_PI * (r + 0.5) / e.height);
            total += x;
        }
    for (double& x : expected) x *= n / total;

    test::Random random(2);
    int elsewhere = 0;
    for (int i = 0; i < n; ++i) {
        const LightSample s = sample_light<F>(view, 0, Vec3(0), random.square());
        ASSERT_TRUE(s.valid);
        ASSERT_NEAR(length(s.wi), 1, 1e-6);
        ASSERT_EQ(s.distance, infinity);
        const Texel t = environment_texel(e, s.wi);
        ++observed[t.row * e.width + t.column];
        // A direction that rounding moved over an edge is seen in the neighbour.
        if (s.radiance != environment_radiance<F>(view, s.wi))
            ++elsewhere;
        else
            ASSERT_EQ(s.pdf, light_pdf<F>(view, 0, Vec3(0), s.wi, Vec3(0), Vec3(0)));
    }
    EXPECT_LT(elsewhere, n * 1e-5);
    for (std::size_t i = 0; i < observed.size(); ++i)
        if (expected[i] == 0) observed[i] = 0; // those few
    EXPECT_GT(test::chi_square_p(observed, expected), 1e-4);
}

// A turned map shows at d what it showed at d turned the other way, and is sampled so.
TEST(Environment, a_turned_map_is_looked_up_and_sampled_where_it_lies) {
    const test::LightScene scene = hard_map();
    for (const float turn : {0.37f / 16, -0.5f / 16}) {
        const double angle = 2 * M_PI * double(turn), c = std::cos(angle), s = std::sin(angle);
        // The direction whose phi is `sign * angle` larger.
        const auto turned = [&](Vec3 d, double sign) {
            return Vec3(DVec3(c * d.x - sign * s * d.z, d.y, c * d.z + sign * s * d.x));
        };
        SceneView view = scene.view();
        const Environment plain = view.environment;
        view.environment.turn = turn;
        test::Random random(7);
        int elsewhere = 0;
        const int n = 100'000;
        for (int i = 0; i < n; ++i) {
            const Vec3 d = random.direction();
            const Texel t = environment_texel(view.environment, d);
            const Texel right = environment_texel(plain, turned(d, 1));
            elsewhere += t.column != right.column || t.row != right.row; // rounding at an edge
            const Vec2 u = random.square();
            const LightSample sample = sample_environment_map(view.environment, u);
            const LightSample there = sample_environment_map(plain, u);
            ASSERT_LT(length(sample.wi - turned(there.wi, -1)), 1e-6);
            ASSERT_EQ(sample.pdf, there.pdf);
            elsewhere += sample.radiance != environment_radiance<F>(view, sample.wi);
        }
        EXPECT_LT(elsewhere, n * 1e-4);
    }
}

TEST(Environment, density_integrates_to_one) {
    const test::LightScene scene = hard_map();
    const SceneView view = scene.view();
    double exact = 0; // texel by texel
    for (int r = 0; r < view.environment.height; ++r)
        for (int c = 0; c < view.environment.width; ++c)
            exact += double(environment_map_pdf(view.environment, {c, r})) *
                     texel_solid_angle(view.environment, r);
    EXPECT_NEAR(exact, 1, 1e-6);
    test::Random random(3);
    test::Mean integral; // over directions
    for (int i = 0; i < test::count(300'000, 10'000'000); ++i) {
        const Vec3 d = random.direction();
        integral.add(4 * M_PI * light_pdf<F>(view, 0, Vec3(0), d, Vec3(0), Vec3(0)));
    }
    EXPECT_NEAR(integral.mean(), 1, 4 * integral.standard_error());
}

// The mean of radiance / pdf is the integral of radiance, which is a sum over texels. Within a
// texel directions must be uniform in solid angle: so is the mean of each coordinate times
// radiance.
TEST(Environment, estimates_are_unbiased_up_to_the_poles) {
    const test::LightScene scene = hard_map(4, 3); // large texels, the poles' are caps
    const SceneView view = scene.view();
    DVec3 truth(0); // integral of L * (1, y, x) over the sphere, red
    const int fine = 600;
    for (int i = 0; i < fine; ++i)
        for (int k = 0; k < 2 * fine; ++k) {
            const double theta = M_PI * (i + 0.5) / fine, phi = M_PI * (k + 0.5) / fine;
            const DVec3 d(std::sin(theta) * std::cos(phi), std::cos(theta),
                          std::sin(theta) * std::sin(phi));
            const double L = scene.map[i * 3 / fine * 4 + k * 4 / (2 * fine)].x;
            truth += L * DVec3(1, d.y, d.x) * std::sin(theta) * (M_PI / fine) * (M_PI / fine);
        }
    test::Random random(4);
    test::Mean whole, y, x;
    for (int i = 0; i < test::count(200'000, 10'000'000); ++i) {
        const LightSample s = sample_light<F>(view, 0, Vec3(0), random.square());
        const double L = s.radiance.x / s.pdf;
        whole.add(L), y.add(L * s.wi.y), x.add(L * s.wi.x);
    }
    EXPECT_NEAR(whole.mean(), truth.x, 4 * whole.standard_error() + 1e-4);
    EXPECT_NEAR(y.mean(), truth.y, 4 * y.standard_error() + 1e-4);
    EXPECT_NEAR(x.mean(), truth.z, 4 * x.standard_error() + 1e-4);
}

// A small sun at either pole of a fine map: the directions must still tell its texels apart, which
// heights measured from the other pole cannot (1 - cos there has 5 values left in a row).
TEST(Environment, directions_keep_their_digits_at_both_poles) {
    constexpr int width = 64, height = 2048;
    for (const int row : {0, 1, height - 2, height - 1}) {
        std::vector<Vec3> texels(width * height, Vec3(0));
        for (int c = 0; c < width; ++c) texels[row * width + c] = Vec3(1);
        test::LightScene scene;
        scene.add(width, height, texels);
        const SceneView view = scene.view();
        test::Random random(6);
        int elsewhere = 0;
        std::vector<double> halves(2);
        for (int i = 0; i < 20'000; ++i) {
            const Vec3 d = sample_light<F>(view, 0, Vec3(0), random.square()).wi;
            elsewhere += environment_texel(view.environment, d).row != row;
            // Inside the row: solid angle grows as theta^2 from the pole.
            const double edge = row < 2 ? row : height - 1 - row, t = M_PI / height;
            const double theta =
                std::atan2(std::hypot(double(d.x), double(d.z)), std::abs(double(d.y)));
            const double part = (theta * theta / (t * t) - edge * edge) / (2 * edge + 1);
            ++halves[part > 0.5];
        }
        EXPECT_LT(elsewhere, 20) << "row " << row;
        EXPECT_GT(test::chi_square_uniform_p(halves), 1e-4) << "row " << row; // false alarm 1e-4
    }
}

TEST(Environment, a_density_in_uv_would_be_infinite_at_the_pole) {
    const test::LightScene scene = hard_map();
    const float pdf = light_pdf<F>(scene.view(), 0, Vec3(0), Vec3(0, 1, 0), Vec3(0), Vec3(0));
    EXPECT_TRUE(std::isfinite(pdf));
    const float sin_theta = 0; // P(texel) * texels / (2 pi^2 sin(theta)), the usual form
    EXPECT_TRUE(std::isinf(0.01f * 16 * 9 / (2 * pi * pi * sin_theta)));
}

TEST(Environment, a_constant_one_lights_evenly) {
    test::LightScene scene;
    scene.environment.radiance = Vec3(2);
    scene.environment.light = 0;
    scene.lights.push_back({LightKind::environment, -1, Vec3(0), Vec3(0)});
    const SceneView view = scene.view();
    EXPECT_EQ(environment_radiance<F>(view, Vec3(0, 0, 1)), Vec3(2));
    test::Random random(5);
    test::Mean E;
    for (int i = 0; i < test::count(100'000, 5'000'000); ++i) {
        const LightSample s = sample_light<F>(view, 0, Vec3(0), random.square());
        ASSERT_EQ(s.pdf, light_pdf<F>(view, 0, Vec3(0), s.wi, Vec3(0), Vec3(0)));
        E.add(s.radiance.x * std::max(s.wi.y, 0.0f) / s.pdf);
    }
    EXPECT_NEAR(E.mean(), 2 * M_PI, 4 * E.standard_error());
}

// U-EDGE: also where the distribution has empty intervals at its ends.
TEST(UEdge, every_environment_sample_is_finite_and_bright) {
    constexpr float edges[] = {0, 0x1p-32f, 0x1p-24f, 0.5f, 1 - 0x1p-24f};
    std::vector<Vec3> texels(16 * 8, Vec3(0));
    texels[3 * 16 + 5] = Vec3(1); // one bright texel: all other intervals are empty
    test::LightScene one;
    one.add(16, 8, texels);
    for (const test::LightScene& scene : {hard_map(), one})
        for (const float x : edges)
            for (const float y : edges) {
                const LightSample s = sample_light<F>(scene.view(), 0, Vec3(0), Vec2(x, y));
                EXPECT_TRUE(s.valid && std::isfinite(s.pdf) && s.pdf > 0) << x << " " << y;
                EXPECT_GT(s.radiance.x, 0) << x << " " << y;
                EXPECT_NEAR(length(s.wi), 1, 1e-6);
            }
}

} // namespace
} // namespace raylab
