// MIS-RR-EQ: light sampling, BSDF sampling, both together and both with Russian roulette have one
// mean.
//
// Metal of four roughnesses under lamps of four sizes (Veach 1995), before a wall that sends light
// on. Which strategy is quiet where is in the table of variances; the means must not differ.
#include "app/tests/accuracy.h"

namespace raylab::app {

namespace {

constexpr double alphas[] = {0.05, 0.15, 0.4, 1};
constexpr double radii[] = {0.05, 0.15, 0.4, 0.8};

struct Strategy {
    const char* name;
    DirectLight direct_light;
    bool roulette;
};
constexpr Strategy strategies[] = {{"light", DirectLight::light, false},
                                   {"bsdf", DirectLight::bsdf, false},
                                   {"mis", DirectLight::mis, false},
                                   {"mis+rr", DirectLight::mis, true}};

Scene room(double alpha, double radius) {
    return parse(
        {.camera = camera({2, 1.3, 0.4}, {0, 0, 0}, 12),
         .materials = fmt::format(
             R"("metal": {{"kind": "conductor", "eta": [0.2, 0.2, 0.2], "k": [3.9, 3.9, 3.9],
                                   "alpha": {}}}, "wall": {}, "lamp": {})",
             alpha, diffuse(DVec3(0.7)), diffuse(DVec3(0), DVec3(1 / (radius * radius)))),
         .shapes = plane({0, 0, 0}, {0, 1, 0}, "metal") + ", " +
                   plane({-3, 0, 0}, {1, 0, 0}, "wall") + ", " +
                   sphere({-1.5, 1, 0}, radius, "lamp"),
         .render = R"("max_depth": 7, "sampler": "independent")",
         .width = 32,
         .height = 32});
}

Estimate render(const std::string& lab, Scene scene, const Strategy& strategy, std::uint32_t seed) {
    scene.render.direct_light = strategy.direct_light;
    scene.render.roulette = strategy.roulette;
    scene.render.seed = seed; // strategies share no random numbers: their errors are independent
    return estimate(trace(lab, scene, count(16, 512)).film);
}

double z_score(Estimate a, Estimate b) {
    return std::fabs(a.mean - b.mean) / std::hypot(a.error, b.error);
}

TEST_P(EachLab, MisRrEqAllStrategiesHaveOneMean) {
    double worst_z = 0, worst_doubled = 0;
    for (const double alpha : alphas)
        for (const double radius : radii) {
            const Scene scene = room(alpha, radius);
            std::vector<Estimate> found;
            std::string row = fmt::format("  MIS-RR-EQ       lab {}  alpha {:<4} radius {:<4}",
                                          GetParam(), alpha, radius);
            for (const Strategy& strategy : strategies) {
                found.push_back(render(GetParam(), scene, strategy, 100 + found.size()));
                row += fmt::format("  {} {:.4f} (var {:.2g})", strategy.name, found.back().mean,
                                   found.back().deviation * found.back().deviation);
            }
            for (std::size_t a = 0; a < found.size(); ++a)
                for (std::size_t b = 0; b < a; ++b)
                    worst_z = std::max(worst_z, z_score(found[a], found[b]));
            fmt::print("{}\n", row);

            // The planted error: both strategies in full, without weights, count light twice.
            const Estimate twice = {found[0].mean + found[1].mean,
                                    std::hypot(found[0].error, found[1].error), 0};
            worst_doubled = std::max(worst_doubled, z_score(twice, found[2]));
        }
    // 96 pairs: a false alarm in 170 choices of seeds.
    figure("MIS-RR-EQ", GetParam(), "largest z of 96 pairs", worst_z, 4, worst_doubled);
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
