// Environment maps and their tables.
#include "common/load/environment_map.h"

#include "common/light/environment.h"
#include "common/load/tests/scene_files.h"

#include <numbers>
#include <random>

namespace raylab {
namespace {

double texel_probability(const EnvironmentCdf& cdf, int width, int x, int y) {
    const std::size_t row = std::size_t(y) * (width + 1) + x;
    return (double(cdf.row[y + 1]) - cdf.row[y]) * (double(cdf.column[row + 1]) - cdf.column[row]);
}

void expect_tables(const EnvironmentCdf& cdf, int width, int height) {
    ASSERT_EQ(cdf.row.size(), std::size_t(height) + 1);
    ASSERT_EQ(cdf.column.size(), std::size_t(height) * (width + 1));
    const auto expect_cdf = [](const float* begin, int count) {
        EXPECT_EQ(begin[0], 0);
        EXPECT_EQ(begin[count], 1);
        for (int i = 0; i < count; ++i) EXPECT_LE(begin[i], begin[i + 1]);
    };
    expect_cdf(cdf.row.data(), height);
    for (int y = 0; y < height; ++y)
        expect_cdf(cdf.column.data() + std::size_t(y) * (width + 1), width);
}

TEST(EnvironmentCdf, IsProportionalToLuminanceTimesSolidAngle) {
    constexpr int width = 16, height = 8;
    std::mt19937 random(3);
    std::exponential_distribution<float> light(1);
    Picture map{width, height, {}};
    for (int i = 0; i < width * height; ++i)
        map.texels.emplace_back(light(random), light(random), light(random));
    for (int x = 0; x < width; ++x) map.texels[3 * width + x] = Vec3(0); // a black row
    const EnvironmentCdf cdf = environment_cdf(map);
    expect_tables(cdf, width, height);

    // The solid angle of a texel exactly: (2 pi / width) (cos(top) - cos(bottom)), which is
    // sin(middle) times a constant. A texel counts at least a sixteenth of its row's mean.
    double total = 0, sum = 0, worst_without_sine = 0, total_without_sine = 0;
    std::vector<double> row_sum(height), row_floored(height);
    const auto L = [&](int x, int y) { return double(luminance(map.texels[y * width + x])); };
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) row_sum[y] += L(x, y);
        for (int x = 0; x < width; ++x)
            row_floored[y] += std::max(L(x, y), row_sum[y] / width / 16);
    }
    const auto weight = [&](int x, int y) {
        const double step = std::numbers::pi / height;
        const double band = std::cos(y * step) - std::cos((y + 1) * step);
        if (row_sum[y] == 0) return 0.0;
        return band * row_sum[y] * std::max(L(x, y), row_sum[y] / width / 16) / row_floored[y];
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            total += weight(x, y);
            total_without_sine += L(x, y);
        }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double p = texel_probability(cdf, width, x, y);
            EXPECT_NEAR(p, weight(x, y) / total, 2e-7) << x << ' ' << y;
            worst_without_sine =
                std::max(worst_without_sine,
                         std::fabs(p - luminance(map.texels[y * width + x]) / total_without_sine));
            sum += p;
        }
    EXPECT_NEAR(sum, 1, 1e-6);
    EXPECT_GT(worst_without_sine, 1e-3) << "without the sine the test must fail";
    EXPECT_EQ(cdf.row[3], cdf.row[4]) << "a black row is never chosen";
}

TEST(EnvironmentCdf, OfABlackMapCoversTheSphereEvenly) {
    const EnvironmentCdf cdf = environment_cdf({4, 2, std::vector<Vec3>(8, Vec3(0))});
    expect_tables(cdf, 4, 2);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x) EXPECT_NEAR(texel_probability(cdf, 4, x, y), 1 / 8.0, 1e-7);
}

// Beside a sun of any brightness every texel that glows can be chosen, with exactly the probability
// in the table, which is a multiple of the random numbers' grain. A black texel is never chosen.
TEST(EnvironmentCdf, KeepsTheSkyBesideASun) {
    for (const float sun : {1e3f, 1e12f, 1e30f, 3e38f}) {
        Picture map{1024, 32, std::vector<Vec3>(32768, Vec3(1e-3f))};
        map.texels[15000] = Vec3(sun), map.texels[3] = Vec3(0), map.texels[4] = Vec3(1e-45f, 0, 0);
        const EnvironmentCdf cdf = environment_cdf(map);
        expect_tables(cdf, 1024, 32);
        for (const auto* table : {&cdf.row, &cdf.column})
            for (const float p : *table) ASSERT_EQ(p * 0x1p24f, std::floor(p * 0x1p24f));
        for (int i = 0; i < 32768; ++i)
            ASSERT_EQ(texel_probability(cdf, 1024, i % 1024, i / 1024) > 0, i != 3) << i;
        EXPECT_GT(texel_probability(cdf, 1024, 15000 % 1024, 15000 / 1024), 0.85);
    }
}

// Light sampling in the shadow of the sun: the irradiance of a sky of 1 on a floor is pi, less the
// part of the sun's own texel (4 standard errors, a false alarm in 16,000 each).
TEST(EnvironmentCdf, LightSamplingFindsTheSkyInTheSunsShadow) {
    constexpr int width = 64, height = 32, sun = 5 * width + 11;
    for (const float radiance : {1e3f, 1e12f}) {
        Picture map{width, height, std::vector<Vec3>(width * height, Vec3(1))};
        map.texels[sun] = Vec3(radiance);
        const EnvironmentCdf cdf = environment_cdf(map);
        Environment e;
        e.radiance = Vec3(1);
        e.width = width, e.height = height;
        e.map = {map.texels.data(), width * height};
        e.row_cdf = {cdf.row.data(), int(cdf.row.size())};
        e.column_cdf = {cdf.column.data(), int(cdf.column.size())};
        std::mt19937 random(4);
        const auto u = [&] { return float(random() >> 8) * 0x1p-24f; };
        const int n = 400'000;
        double sum = 0, squares = 0;
        for (int i = 0; i < n; ++i) {
            const float x = u(), y = u();
            const LightSample s = sample_environment_map(e, Vec2(x, y));
            if (!s.valid || s.radiance.x == radiance || s.wi.y <= 0) continue;
            sum += s.radiance.x * s.wi.y / s.pdf;
            squares += double(sqr(s.radiance.x * s.wi.y / s.pdf));
        }
        const double mean = sum / n, error = std::sqrt((squares / n - mean * mean) / n);
        const double top = std::numbers::pi * 5 / height, bottom = std::numbers::pi * 6 / height;
        const double hidden =
            std::numbers::pi / width * (std::pow(std::cos(top), 2) - std::pow(std::cos(bottom), 2));
        EXPECT_NEAR(mean, std::numbers::pi - hidden, 4 * error) << radiance;
        EXPECT_LT(error, 0.05);
    }
}

TEST(EnvironmentMap, IsReadWithItsTopRowFirst) {
    TemporaryFolder folder;
    // RGBE (128, 64, 32, 129) is (1, 0.5, 0.25); (128, 128, 128, 128) is 0.5.
    folder.write("sky.hdr", hdr(1, 2, std::string("\x80\x40\x20\x81\x80\x80\x80\x80", 8)));
    const Scene scene = load(
        with(
            good_scene, R"({"kind": "point", "position": [0, 5, 0], "intensity": [1, 1, 1]})",
            R"({"kind": "environment", "file": "sky.hdr", "scale": 3}, {"kind": "point", "position": [0, 5, 0], "intensity": [1, 1, 1]})"),
        folder);
    EXPECT_EQ(scene.environment_width, 1);
    EXPECT_EQ(scene.environment_height, 2);
    EXPECT_EQ(scene.environment_map.at(0), Vec3(1, 0.5f, 0.25f));
    EXPECT_EQ(scene.environment_map.at(1), Vec3(0.5f));
    EXPECT_EQ(scene.environment_radiance, Vec3(3));
    EXPECT_EQ(scene.environment_light, 2) << "the last light, wherever it stands in the file";
    EXPECT_EQ(scene.lights.back().kind, LightKind::environment);
}

std::vector<int> rotated(int width, double degrees, float* left = nullptr) {
    Picture map{width, 2, {}};
    for (int i = 0; i < 2 * width; ++i) map.texels.push_back(Vec3(float(i)));
    const float turn = rotate_map(map, degrees);
    if (left) *left = turn;
    std::vector<int> columns; // for each column of the turned first row, its number before
    for (int x = 0; x < width; ++x) {
        columns.push_back(int(map.texels[x].x));
        EXPECT_EQ(map.texels[width + x].x, map.texels[x].x + float(width));
    }
    return columns;
}

TEST(EnvironmentMap, IsTurnedLikeAShape) {
    float left = 1;
    EXPECT_EQ(rotated(8, 0, &left), (std::vector{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(left, 0);
    // The texels towards +z, u = 1/4, come to +x, u = 0, as does a point of a shape that is turned
    // by 90 degrees.
    EXPECT_EQ(rotated(8, 90, &left), (std::vector{2, 3, 4, 5, 6, 7, 0, 1}));
    EXPECT_EQ(left, 0);
    EXPECT_EQ(rotated(8, -45), (std::vector{7, 0, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(rotated(8, 90 - 360 * 3), rotated(8, 90));
    for (const int width : {7, 1000, 4095})
        for (int k = -width; k <= 2 * width; ++k) {
            const std::vector<int> columns = rotated(width, 360.0 / width * k, &left);
            ASSERT_EQ(columns[0], (k + width) % width) << width << ' ' << k;
            ASSERT_EQ(left, 0) << width << ' ' << k;
        }
    // For an angle between two columns, the texels move by whole columns and the rest is returned.
    EXPECT_EQ(rotated(8, 50, &left)[0], 1);
    EXPECT_NEAR(left, 5 / 360.0, 1e-9);
    EXPECT_EQ(rotated(8, -50, &left)[0], 7);
    EXPECT_NEAR(left, -5 / 360.0, 1e-9);
    for (const double any : {22.5, -22.5, 359.999, 1e38, -1e38, 1e-300}) {
        rotated(1, any, &left);
        EXPECT_LE(std::fabs(left), 0.5f) << any;
        rotated(8, any, &left);
        EXPECT_LE(std::fabs(left), 0.5f / 8) << any;
    }
}

TEST(EnvironmentMap, TurnedInASceneIsAShiftedMap) {
    TemporaryFolder folder;
    std::string texels; // blue grows along the row
    for (int i = 0; i < 16; ++i) texels += std::string("\x80\x40", 2) + char(10 * i) + '\x81';
    folder.write("sky.hdr", hdr(8, 2, texels));
    const auto scene = [&](const std::string& more) {
        return load(with(good_scene,
                         R"({"kind": "point", "position": [0, 5, 0], "intensity": [1, 1, 1]})",
                         R"({"kind": "environment", "file": "sky.hdr")" + more + "}"),
                    folder);
    };
    const Scene plain = scene(""), turned = scene(R"(, "rotate_deg": 405)"),
                between = scene(R"(, "rotate_deg": -10)");
    EXPECT_EQ(turned.environment_turn, 0);
    EXPECT_NEAR(between.environment_turn, -10 / 360.0, 1e-8);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 8; ++x) {
            EXPECT_EQ(turned.environment_map[y * 8 + x],
                      plain.environment_map[y * 8 + (x + 1) % 8]);
            // The tables belong to the turned map.
            EXPECT_EQ(turned.environment_column_cdf[y * 9 + x + 1] -
                              turned.environment_column_cdf[y * 9 + x] >
                          0.125f,
                      (x + 1) % 8 >= 4)
                << x;
        }
    EXPECT_EQ(view(between).environment.turn, between.environment_turn);
}

} // namespace
} // namespace raylab
