// RNG-CORR: the random numbers of a path's first bounce, read off the image.
//
// A diffuse floor under a sky whose red is the longitude of a direction and whose green is sin^2 of
// its angle from the zenith. Cosine-distributed directions make both uniform in [0, 1], so a
// pixel's red and green are the two numbers of its first bounce, folded.
#include "app/tests/accuracy.h"
#include "common/load/environment_map.h"

namespace raylab::app {

namespace {

constexpr int side = 128;

Scene dome() {
    Scene scene = parse({.camera = camera({0, 1, 1}, {0, 0, 0}, 1e-3),
                         .materials = R"("floor": )" + diffuse(DVec3(1)),
                         .shapes = quad({-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, "floor"),
                         .lights = white_sky,
                         .render = R"("max_depth": 2, "direct_light": "bsdf")",
                         .width = side,
                         .height = side});
    Picture sky;
    sky.width = 512, sky.height = 512;
    for (int y = 0; y < sky.height; ++y)
        for (int x = 0; x < sky.width; ++x) {
            const double zenith = M_PI * (y + 0.5) / sky.height, s = std::sin(zenith);
            sky.texels.push_back(Vec3((x + 0.5) / sky.width, s * s, 1));
        }
    const EnvironmentCdf cdf = environment_cdf(sky);
    scene.environment_radiance = Vec3(1);
    scene.environment_width = sky.width;
    scene.environment_height = sky.height;
    scene.environment_map = sky.texels;
    scene.environment_row_cdf = cdf.row;
    scene.environment_column_cdf = cdf.column;
    return scene;
}

// [iteration][pixel] of the two numbers.
using Numbers = std::vector<std::vector<Vec2>>;

Numbers numbers(const std::string& lab, const Scene& scene, int spp) {
    const std::unique_ptr<Renderer> renderer = find_lab(lab).make(scene, {});
    Numbers result;
    Film before = renderer->film();
    for (int i = 0; i < spp; ++i) {
        renderer->add_iteration();
        const Film now = renderer->film();
        result.emplace_back();
        for (std::size_t p = 0; p < now.pixels.size(); ++p)
            result.back().emplace_back(now.pixels[p].sum[0] - before.pixels[p].sum[0],
                                       now.pixels[p].sum[1] - before.pixels[p].sum[1]);
        before = now;
    }
    return result;
}

template <class Pair>
double correlation(const Numbers& n, int lag_sample, int lag_pixel, Pair pair) {
    test::Correlation c;
    for (std::size_t s = 0; s + lag_sample < n.size(); ++s)
        for (std::size_t p = 0; p + lag_pixel < n[s].size(); ++p) {
            const auto [a, b] = pair(n[s][p], n[s + lag_sample][p + lag_pixel]);
            c.add(a, b);
        }
    return std::fabs(c.r());
}

TEST_P(EachLab, RngCorrFirstBouncesOfPixelsAndSamplesAreUnrelated) {
    for (const SamplerKind kind : {SamplerKind::independent, SamplerKind::sobol}) {
        Scene scene = dome();
        scene.render.sampler = kind;
        const char* name = kind == SamplerKind::sobol ? "Sobol" : "independent";
        const int spp = count(8, 64);
        const Numbers n = numbers(GetParam(), scene, spp);
        const double tolerance = 4 / std::sqrt(1.0 * side * side * spp) + 1e-3; // .005 at 1e6
        const auto same = [](Vec2 a, Vec2 b) { return std::pair(a.x, b.x); };
        const auto other = [](Vec2 a, Vec2 b) { return std::pair(a.x, b.y); };
        const auto second = [](Vec2 a, Vec2 b) { return std::pair(a.y, b.y); };
        const auto report = [&](const char* what, double r) {
            figure("RNG-CORR", GetParam(), fmt::format("{}: {}", name, what), r, tolerance);
        };
        report("u1 of neighbouring pixels", correlation(n, 0, 1, same));
        report("u2 of neighbouring pixels", correlation(n, 0, 1, second));
        report("u1 of pixels in a column", correlation(n, 0, side, same));
        report("u1 and u2 of one bounce", correlation(n, 0, 0, other));
        report("u1 and u2 of neighbouring pixels", correlation(n, 0, 1, other));
        // Samples of a Sobol sequence avoid each other: there only the independent sampler is flat.
        if (kind == SamplerKind::independent) {
            report("u1 of successive samples", correlation(n, 1, 0, same));
            report("u1 and u2 of successive samples", correlation(n, 1, 0, other));
        }

        std::vector<double> cells(16 * 16);
        for (const Vec2& v : n[0])
            ++cells[std::min(15, static_cast<int>(v.x * 16)) * 16 +
                    std::min(15, static_cast<int>(v.y * 16))];
        const double p = test::chi_square_uniform_p(cells);
        note("RNG-CORR", GetParam(), fmt::format("{}: chi-square of 256 cells, p", name), p);
        EXPECT_GT(p, 1e-3);
        EXPECT_LT(p, 1 - 1e-3);
    }
}

// What the test would say of a generator that is seeded with the pixel's number and not hashed.
TEST(RngCorr, ARawSeedIsCaught) {
    Numbers n(1);
    for (std::uint32_t pixel = 0; pixel < side * side; ++pixel) {
        const std::uint32_t first = 1664525u * pixel + 1013904223u;
        n[0].emplace_back(first * 0x1p-32, (1664525u * first + 1013904223u) * 0x1p-32);
    }
    const double r = correlation(n, 0, 1, [](Vec2 a, Vec2 b) { return std::pair(a.x, b.x); });
    note("RNG-CORR", "--", "raw LCG seed: u1 of neighbouring pixels", r);
    EXPECT_GT(r, 0.99);
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
