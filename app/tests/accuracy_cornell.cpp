// CORNELL: the published box, all grey 0.75, against an independent tracer in double; and the
// exchange between two squares against their form factor.
#include "app/tests/accuracy.h"
#include "app/tests/double_tracer.h"

#include <functional>

namespace raylab::app {

namespace {

constexpr int side = 32, tile = 8;
constexpr double grey = 0.75;

Scene grey_box() {
    Scene scene = load_scene(find_scene("cornell"));
    for (Material& material : scene.materials) {
        material.reflectance = Vec3(static_cast<float>(grey));
        if (is_emissive(material)) material.emission = Vec3(10);
    }
    set_film_size(scene.camera, side, side);
    scene.render.sampler = SamplerKind::independent;
    scene.render.max_depth = 6;
    return scene;
}

struct Tiles {
    std::vector<double> mean, variance; // of each tile's mean
};

Tiles tiles(int spp, const std::function<double(int x, int y, int sample)>& value) {
    Tiles result;
    for (int y0 = 0; y0 < side; y0 += tile)
        for (int x0 = 0; x0 < side; x0 += tile) {
            double sum = 0, variance = 0;
            for (int y = y0; y < y0 + tile; ++y)
                for (int x = x0; x < x0 + tile; ++x) {
                    test::Mean pixel;
                    for (int s = 0; s < spp; ++s) pixel.add(value(x, y, s));
                    sum += pixel.mean();
                    variance += pixel.standard_error() * pixel.standard_error() * spp / (spp - 1);
                }
            result.mean.push_back(sum / (tile * tile));
            result.variance.push_back(variance / (1.0 * tile * tile * tile * tile));
        }
    return result;
}

Tiles tiles_of(const Film& film) {
    Tiles result;
    for (int y0 = 0; y0 < side; y0 += tile)
        for (int x0 = 0; x0 < side; x0 += tile) {
            Film part(tile, tile);
            for (int i = 0; i < tile * tile; ++i)
                part.pixels[i] = film.pixels[(y0 + i / tile) * side + x0 + i % tile];
            const Estimate e = estimate(part);
            result.mean.push_back(e.mean);
            result.variance.push_back(e.error * e.error);
        }
    return result;
}

Tiles reference(double albedo, int spp) {
    const Scene scene = grey_box();
    const DoubleTracer tracer(scene, albedo, 10);
    std::mt19937_64 random(61);
    return tiles(spp, [&](int x, int y, int) { return tracer.sample(x, y, random); });
}

struct Distance {
    double worst_z, p; // p of the sum of squares over all tiles
};

Distance distance(const Tiles& a, const Tiles& b) {
    double worst = 0, chi2 = 0;
    for (std::size_t i = 0; i < a.mean.size(); ++i) {
        const double z = (a.mean[i] - b.mean[i]) / std::sqrt(a.variance[i] + b.variance[i]);
        worst = std::max(worst, std::fabs(z));
        chi2 += z * z;
    }
    return {worst, test::chi_square_tail(chi2, static_cast<double>(a.mean.size()))};
}

TEST_P(EachLab, CornellGreyBoxAgreesWithAnIndependentTracer) {
    const int spp = count(48, 4096);
    const Tiles ours = tiles_of(trace(GetParam(), grey_box(), spp).film);
    const Distance right = distance(ours, reference(grey, spp));
    const Distance darker = distance(ours, reference(grey - 0.015, spp)); // the planted error
    // 16 tiles: a false alarm in 1000 choices of seeds.
    figure("CORNELL", GetParam(), "grey box: largest z of 16 tiles", right.worst_z, 4);
    note("CORNELL", GetParam(), "grey box: p of chi-square over tiles", right.p);
    note("CORNELL", GetParam(), "against albedo 0.735: p", darker.p);
    EXPECT_GT(right.p, 1e-4);
    EXPECT_LT(darker.p, 1e-4);
}

// Hottel 1931, parallel unit squares at distance 1. Halfway between them the camera sees one
// square, equal pixels equal areas.
TEST_P(EachLab, CornellTwoSquaresExchangeTheirFormFactor) {
    const double form_factor =
        2 / M_PI *
        (std::log(std::sqrt(4.0 / 3)) + 2 * std::sqrt(2) * std::atan(std::sqrt(0.5)) - M_PI / 2);
    EXPECT_NEAR(form_factor, 0.19982490, 1e-8);
    Scene scene = load_scene(find_scene("form_factor"));
    scene.render.sampler = SamplerKind::independent;
    for (const DirectLight strategy : {DirectLight::light, DirectLight::bsdf, DirectLight::mis}) {
        scene.render.direct_light = strategy;
        const Estimate found = estimate(trace(GetParam(), scene, count(64, 4096)).film);
        const double tolerance = 1e-4 * form_factor + 4 * found.error;
        figure(
            "CORNELL", GetParam(),
            fmt::format("form factor, strategy {}: {:.6f}", static_cast<int>(strategy), found.mean),
            std::fabs(found.mean - form_factor), tolerance, 0.05 * form_factor);
    }
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
