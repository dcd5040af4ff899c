// MIRROR-IMG: what a plane mirror shows is the object behind it; two mirrors show rho^k of it.
#include "app/tests/accuracy.h"

namespace raylab::app {

namespace {

// A glowing chequered board and a sphere at depth z, mirrored in z = 0 by a sign.
std::string object(double sign) {
    std::string shapes = sphere({0.4, -0.3, sign * 3.5}, 0.35, "m0");
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j) {
            const double x = -1.6 + 0.4 * i, y = -1.6 + 0.4 * j, z = sign * (4 + 0.1 * i);
            const double z2 = sign * (4 + 0.1 * (i + 1));
            shapes += ", " + quad({x, y, z}, {x + 0.4, y, z2}, {x + 0.4, y + 0.4, z2},
                                  {x, y + 0.4, z}, fmt::format("m{}", (i * 3 + j * 5) % 4));
        }
    return shapes;
}

std::string glowing() {
    std::string materials;
    for (int i = 0; i < 4; ++i)
        materials +=
            fmt::format(R"("m{}": {}, )", i, diffuse(DVec3(0), DVec3(1 + i, 4 - i, 0.5 * i)));
    return materials;
}

// The camera looks into the mirror; the object is behind its back.
TEST_P(EachLab, MirrorImgIsTheVirtualObject) {
    const auto picture = [&](const std::string& shapes, double reflectance) {
        return trace(GetParam(),
                     parse({.camera = camera({0.1, 0.2, 2}, {0, 0, 0}, 25),
                            .materials =
                                glowing() +
                                fmt::format(R"("mirror": {{"kind": "mirror", "reflectance": {}}})",
                                            text(DVec3(reflectance))),
                            .shapes = shapes,
                            .render = R"("max_depth": 2, "direct_light": "bsdf")",
                            .width = 96,
                            .height = 96}),
                     count(8, 256))
            .film;
    };
    const auto distance = [](const Film& a, const Film& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i)
            sum += std::fabs(pixel_mean(a.pixels[i]) - pixel_mean(b.pixels[i]));
        return sum / a.pixels.size();
    };
    const Film virtual_object = picture(object(-1), 1);
    const std::string mirror = plane({0, 0, 0}, {0, 0, 1}, "mirror");
    const std::string tilted = plane({0, 0, 0}, {0.001, 0, 1}, "mirror");
    figure("MIRROR-IMG", GetParam(), "mean difference of a pixel",
           distance(picture(object(1) + ", " + mirror, 1), virtual_object), 1e-4,
           distance(picture(object(1) + ", " + tilted, 1), virtual_object));
    figure(
        "MIRROR-IMG", GetParam(), "reflectance 0.9 against 0.9 of it",
        [&] {
            const Film film = picture(object(1) + ", " + mirror, 0.9);
            double off = 0;
            for (std::size_t i = 0; i < film.pixels.size(); ++i)
                off += std::fabs(pixel_mean(film.pixels[i]) -
                                 0.9 * pixel_mean(virtual_object.pixels[i]));
            return off / film.pixels.size();
        }(),
        1e-4);
}

// Mirrors at x = 0 and x = 1, a light across the far end. Unfolded, the corridor is a straight
// line: aimed at x = 0.5 + k there, a ray is reflected k times.
TEST_P(EachLab, MirrorImgTwentyImagesFadeByRho) {
    const double rho = static_cast<float>(0.9);
    double worst = 0, planted = 0;
    for (int k = 0; k <= 20; ++k) {
        const Film film =
            trace(
                GetParam(),
                parse({.camera = camera({0.5, 0, 0}, {0.5 + k, 0, -8}, 0.01),
                       .materials = R"("mirror": {"kind": "mirror", "reflectance": [0.9, 0.9, 0.9]},
                                         "light": )" +
                                    diffuse(DVec3(0), DVec3(1)),
                       .shapes = plane({0, 0, 0}, {1, 0, 0}, "mirror") + ", " +
                                 plane({1, 0, 0}, {1, 0, 0}, "mirror") + ", " +
                                 quad({-1, -1, -8}, {2, -1, -8}, {2, 1, -8}, {-1, 1, -8}, "light"),
                       .render = R"("max_depth": 40, "roulette": false)",
                       .width = 4,
                       .height = 4}),
                2)
                .film;
        worst = std::max(worst, worst_pixel(film, std::pow(rho, k)));
        planted = std::max(planted, worst_pixel(film, std::pow(rho, k + 1)));
    }
    figure("MIRROR-IMG", GetParam(), "images 0 to 20: worst off rho^k", worst, 1e-5, planted);
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
