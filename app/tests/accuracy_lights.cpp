// SPHLIGHT, POLYLIGHT: the irradiance from a sphere and from a square, however it is sampled.
//
// A white floor shows E / pi. The camera stands close to the receiver and below the light, with so
// narrow a field of view that the receiver is a point.
#include "app/tests/accuracy.h"

namespace raylab::app {

namespace {

Estimate render(const std::string& lab, DVec3 receiver, DVec3 eye, const std::string& light,
                double radiance, const std::string& strategy, int spp) {
    const Scene scene =
        parse({.camera = camera(eye, receiver, 1e-3),
               .materials = R"("floor": )" + diffuse(DVec3(1)) + R"(, "light": )" +
                            diffuse(DVec3(0), DVec3(radiance)),
               .shapes = plane({0, 0, 0}, {0, 1, 0}, "floor") + ", " + light,
               .render = R"("max_depth": 2, "sampler": "independent", "direct_light": ")" +
                         strategy + '"',
               .width = 32,
               .height = 32});
    return estimate(trace(lab, scene, spp).film);
}

// A sphere of radius r at distance d, tilted from the normal by theta and wholly above the horizon,
// sends E = pi L (r / d)^2 cos(theta). With L = (d / r)^2 the floor shows cos(theta).
TEST_P(EachLab, SphLightIsAsBrightAsAPointAtItsCentre) {
    for (const double tilt : {0.0, 0.4, 1.0})
        for (const double ratio : {0.9, 0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8}) {
            if (std::cos(tilt) < ratio + 0.01) continue; // dips below the horizon
            const std::string lamp = sphere({std::sin(tilt), std::cos(tilt), 0}, ratio, "light");
            const double truth = std::cos(tilt), radiance = 1 / (ratio * ratio);
            for (const std::string strategy : {"light", "mis", "bsdf"}) {
                if (strategy == "bsdf" && ratio < 0.4) continue; // too noisy to tell
                const Estimate found = render(GetParam(), {0, 0, 0}, {-0.1, 0.05, 0}, lamp,
                                              radiance, strategy, count(8, 512));
                const double tolerance = 1e-5 + 4 * found.error;
                // The naive cone, 1 - cos from rounded numbers, has a density that is off by this:
                const float sin2 = static_cast<float>(ratio * ratio);
                const double naive = (1.0 - std::sqrt(1 - ratio * ratio)) /
                                         static_cast<double>(1 - sqrtf(1 - sin2)) -
                                     1;
                figure("SPHLIGHT", GetParam(),
                       fmt::format("r/d {}, tilt {}, {}", ratio, tilt, strategy),
                       std::fabs(found.mean - truth), tolerance,
                       ratio <= 1e-3 ? std::optional(std::fabs(naive)) : std::nullopt);
            }
        }
}

// Lambert 1760: E / L = 1/2 sum of angle(v_i, v_i+1) n . normalize(v_i x v_i+1).
double lambert(DVec3 receiver, double h) {
    const DVec3 corner[4] = {{-0.5, h, -0.5}, {0.5, h, -0.5}, {0.5, h, 0.5}, {-0.5, h, 0.5}};
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        const DVec3 a = glm::normalize(corner[i] - receiver);
        const DVec3 b = glm::normalize(corner[(i + 1) % 4] - receiver), normal = cross(a, b);
        sum += std::atan2(glm::length(normal), dot(a, b)) * glm::normalize(normal).y;
    }
    return std::fabs(sum) / 2;
}

TEST_P(EachLab, PolyLightIsLambertsFormula) {
    const DVec3 receiver(0.3, 0, -0.2);
    EXPECT_NEAR(lambert(receiver, 1), 0.6492081358, 1e-10);
    EXPECT_NEAR(lambert(receiver, 0.1), 2.9014064814, 1e-10);
    EXPECT_NEAR(lambert(receiver, 0.01), 3.1388310990, 1e-10);
    for (const double h : {1.0, 0.1, 0.01}) {
        const std::string lamp =
            quad({-0.5, h, -0.5}, {0.5, h, -0.5}, {0.5, h, 0.5}, {-0.5, h, 0.5}, "light");
        const DVec3 eye = receiver + DVec3(-0.6 * h, 0.4 * h, 0.1 * h);
        const double truth = lambert(receiver, h);
        for (const std::string strategy : {"light", "mis", "bsdf"}) {
            // At a distance of a hundredth of the square's size, light sampling alone is too noisy
            // to test: the variance grows with 1 / h^2. With MIS, the heuristic gives nearly all
            // weight to BSDF sampling there.
            if (strategy == "light" && h < 0.1) continue;
            const Estimate found =
                render(GetParam(), receiver, eye, lamp, M_PI, strategy, count(32, 1024));
            // The planted error: the receiver 0.2 away from where it should be.
            const double naive = std::fabs(lambert(receiver + DVec3(0.2, 0, -0.2), h) - truth);
            figure("POLYLIGHT", GetParam(),
                   fmt::format("h {}, {}: {:.5f}, found {:.5f}", h, strategy, truth, found.mean),
                   std::fabs(found.mean - truth), 1e-5 + 4 * found.error,
                   h == 1 ? std::optional(naive) : std::nullopt);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
