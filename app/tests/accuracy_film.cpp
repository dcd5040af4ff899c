// ACC-LONG, NAN-POISON: long sums, and samples that are no numbers.
#include "app/tests/accuracy.h"

namespace raylab::app {

namespace {

// --- ACC-LONG ---------------------------------------------------------------------------------

// Adds `n` samples to a film's pixel, to a long double and, naively, to a float.
template <class Next>
void add_up(const char* what, long long n, double naive_tolerance, const Next& next) {
    FilmPixel pixel{};
    long double truth = 0;
    float naive = 0;
    for (long long i = 0; i < n; ++i) {
        const float x = next(i);
        add_sample(pixel, Vec3(x));
        truth += x;
        naive += x;
    }
    EXPECT_EQ(pixel.samples, n);
    const auto off = [&](double sum) { return std::fabs(static_cast<double>(sum / truth - 1)); };
    figure("ACC-LONG", "--", fmt::format("{} of {}", n, what), off(pixel.sum[0]), 1e-6);
    note("ACC-LONG", "--", "  the same in float", off(naive));
    EXPECT_GT(off(naive), naive_tolerance);
}

TEST(AccLong, DoubleSumsLoseNothingThatAFloatImageShows) {
    const long long n = count(2'000'000, 100'000'000);
    add_up("a constant 0.1", n, 1e-3, [](long long) { return 0.1f; });
    test::Random random(45);
    add_up("a heavy tail", n, 1e-6, [&](long long) {
        const float u = 1 - random.u();
        return 1 / std::pow(u, 0.75f); // density ~ x^(-7/3): infinite variance
    });
    add_up("1e4 and 1e-3 in turn", n, 1e-6, [](long long i) { return i % 2 ? 1e-3f : 1e4f; });
}

// --- NAN-POISON -------------------------------------------------------------------------------

TEST(NanPoison, TheFilmCountsAndKeepsOut) {
    FilmPixel clean{}, poisoned{};
    test::Random random(46);
    for (int i = 0; i < 1'000'000; ++i) {
        const Vec3 x(random.u(), random.u(), random.u());
        if (i == 4321) add_sample(poisoned, Vec3(0, NAN, 1));
        if (i == 54321) add_sample(poisoned, Vec3(1, 0, infinity));
        add_sample(clean, x);
        add_sample(poisoned, x);
    }
    EXPECT_EQ(poisoned.rejected, 2u);
    poisoned.rejected = 0;
    EXPECT_EQ(std::memcmp(&clean, &poisoned, sizeof clean), 0);
}

// Through a lab: a lamp whose radiance is NaN, and one whose radiance is infinite, seen directly.
TEST_P(EachLab, NanPoisonIsCountedAndChangesNoOtherSample) {
    const auto square = [](double x, const char* material) {
        return quad({x, 0, 0}, {x + 0.01, 0, 0}, {x + 0.01, 0.01, 0}, {x, 0.01, 0}, material);
    };
    Scene scene = parse({.camera = camera({0, 0, 2}, {0, 0, 0}, 50),
                         .materials = R"("a": )" + diffuse(DVec3(0.5), DVec3(1)) + R"(, "b": )" +
                                      diffuse(DVec3(0.5), DVec3(1)) + R"(, "wall": )" +
                                      diffuse(DVec3(0.5), DVec3(0.2, 0.3, 0.4)),
                         .shapes = square(-0.5, "a") + ", " + square(0.5, "b") + ", " +
                                   quad({-3, -3, -1}, {3, -3, -1}, {3, 3, -1}, {-3, 3, -1}, "wall"),
                         .render = R"("max_depth": 1)",
                         .width = 64,
                         .height = 64});
    const Traced clean = trace(GetParam(), scene, 16);
    scene.materials[0].emission.y = NAN;
    scene.materials[1].emission.z = infinity;
    const Traced poisoned = trace(GetParam(), scene, 16);

    unsigned rejected = 0;
    for (std::size_t i = 0; i < clean.film.pixels.size(); ++i) {
        const FilmPixel& pixel = poisoned.film.pixels[i];
        rejected += pixel.rejected;
        EXPECT_EQ(pixel.rejected + pixel.samples, 16u);
        if (pixel.rejected == 0) {
            EXPECT_EQ(std::memcmp(&pixel, &clean.film.pixels[i], sizeof pixel), 0) << "pixel " << i;
        }
    }
    EXPECT_GT(rejected, 1u);
    EXPECT_LT(rejected, 64u);
    EXPECT_EQ(poisoned.ledger.rejected, rejected);
    EXPECT_EQ(clean.ledger.rejected, 0u);
    const Image image = develop(poisoned.film);
    for (const Vec3& mean : image.mean) EXPECT_TRUE(is_finite(mean));
    note("NAN-POISON", GetParam(), "samples kept out of 65536", rejected);

    // Without the check for finite values, one such sample would make its pixel's sum NaN.
    double naive = 0;
    for (const float x : {1.0f, NAN, 2.0f}) naive += x;
    EXPECT_FALSE(std::isfinite(naive)); // also shows that this build has not optimised NaN away
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
