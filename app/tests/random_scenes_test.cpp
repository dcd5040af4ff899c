// Small scenes at random: whatever the scene, the labs trace the same paths, no sample is NaN or
// infinite or negative, and under a white sky nothing is brighter than the sky.
#include "app/tests/accuracy.h"

namespace raylab::app {

namespace {

class Generator {
  public:
    explicit Generator(unsigned seed) : random_(seed) {}

    // passive: surfaces only reflect, with sampling weights of at most 1, under a sky of 1.
    Scene scene(bool passive) {
        const int materials = 2 + below(4);
        std::string names, shapes, lights;
        for (int i = 0; i < materials; ++i)
            names += fmt::format(R"({}"m{}": {})", i ? ", " : "", i, material(passive));
        const int n = 1 + below(9);
        for (int i = 0; i < n; ++i) shapes += (i ? ", " : "") + shape(materials);
        if (passive || below(2)) lights = white_sky;
        for (int i = passive ? 2 : below(3); i < 2; ++i)
            lights += fmt::format(R"({}{{"kind": "point", "position": {}, "intensity": {}}})",
                                  lights.empty() ? "" : ", ", text(point(3)), text(colour(5)));
        const std::string lens = below(4) == 0
                                     ? fmt::format(R"(, "lens_radius": {}, "focus_distance": {})",
                                                   0.01 + 0.2 * u(), 1 + 4 * u())
                                     : "";
        const std::string direct_light[] = {"mis", "light", "bsdf"};
        SceneText t{.camera = camera(point(4), point(1), 20 + 80 * u(), lens),
                    .materials = names,
                    .shapes = shapes,
                    .lights = lights,
                    .render = fmt::format(
                        R"("max_depth": {}, "roulette": {}, "direct_light": "{}", "sampler": "{}",
                           "seed": {})",
                        1 + below(14), !passive && below(2) == 0,
                        passive ? "bsdf" : direct_light[below(3)],
                        below(2) ? "sobol" : "independent", below(1000)),
                    .width = 12,
                    .height = 9};
        if (!passive && below(5) == 0)
            t.render = R"("integrator": "whitted", "max_depth": )" + std::to_string(1 + below(7));
        // All that the loader takes is allowed, for instance a camera inside a shape. The loader
        // refuses glowing spheres that would have to become planes.
        return parse(t);
    }

  private:
    double u() { return random_.u(); }
    int below(int n) { return static_cast<int>(u() * n); }
    DVec3 point(double reach) {
        const double x = u(), y = u();
        return reach * (2.0 * DVec3(x, y, u()) - 1.0);
    }
    DVec3 colour(double most) {
        const double r = u(), g = u();
        return most * DVec3(r, g, u());
    }

    std::string material(bool passive) {
        const std::string emission =
            !passive && below(3) == 0 ? R"(, "emission": )" + text(colour(4)) : "";
        const double alpha = std::pow(10, -4 * u());
        const char* microfacets = passive || below(2) ? "ggx" : "beckmann";
        switch (below(passive ? 5 : 6)) {
        case 0:
            return R"({"kind": "diffuse", "reflectance": )" + text(colour(1)) + emission + "}";
        case 1:
            return R"({"kind": "mirror", "reflectance": )" + text(colour(1)) + emission + "}";
        case 2:
            return fmt::format(R"({{"kind": "glass", "ior": {}, "fresnel": "{}"}})", 0.4 + 2 * u(),
                               below(4) ? "exact" : "schlick");
        case 3:
            return fmt::format(
                R"({{"kind": "conductor", "eta": {}, "k": {}, "alpha": {}, "microfacets": "{}"{}}})",
                text(DVec3(0.1) + colour(2)), text(colour(5)), alpha, microfacets, emission);
        case 4:
            return fmt::format(
                R"({{"kind": "rough_dielectric", "ior": {}, "alpha": {}, "microfacets": "{}"}})",
                0.4 + 2 * u(), alpha, microfacets);
        default:
            return fmt::format(
                R"({{"kind": "phong", "reflectance": {}, "specular": {}, "exponent": {}{}}})",
                text(colour(0.5)), text(colour(0.5)), std::pow(10, 4 * u()), emission);
        }
    }

    std::string shape(int materials) {
        const std::string m = fmt::format("m{}", below(materials));
        const DVec3 p = point(2);
        const std::string turned =
            fmt::format(R"(, "transform": {{"rotate": [{{"axis": {}, "angle_deg": {}}}]}})",
                        text(point(1) + DVec3(0, 0, 2)), 360 * u());
        switch (below(4)) {
        case 0:
            return sphere(p, 0.1 + 1.5 * u() * u(), m);
        case 1:
            return box(p, p + DVec3(0.1) + colour(2), m, below(2) ? turned : "");
        case 2: {
            const DVec3 side = DVec3(0.1) + point(1),
                        across = cross(side, point(1) + DVec3(0, 0, 3));
            return quad(p, p + side, p + side + across, p + across, m);
        }
        default:
            return triangle(p, p + point(2), p + point(2), m);
        }
    }

    test::Random random_;
};

double largest_sample(const Film& film) { // of films with one sample a pixel
    double largest = 0;
    for (const FilmPixel& pixel : film.pixels)
        for (const double sum : pixel.sum) largest = std::max(largest, sum);
    return largest;
}

TEST(RandomScenes, LabsAgreePathByPathAndNoSampleIsWrong) {
    const int scenes = count(200, 5000);
    long long paths = 0, other_paths = 0, other_values = 0, lit = 0;
    for (int i = 0; i < scenes; ++i) {
        const Scene scene = Generator(i).scene(false);
        const Traced one = trace("01", scene, 2), two = trace("02", scene, 2);
        long long other_here = 0;
        for (std::size_t k = 0; k < one.records.size(); ++k) {
            const PathRecord &a = one.records[k], &b = two.records[k];
            other_here += a.hits != b.hits || a.length != b.length || a.end != b.end ||
                          a.shadow_rays != b.shadow_rays;
        }
        if (!fused) {
            EXPECT_EQ(other_here, 0) << "scene " << i;
        }
        other_paths += other_here;
        paths += one.records.size();
        for (const Traced* traced : {&one, &two}) {
            EXPECT_EQ(traced->ledger.rejected, 0u) << "scene " << i;
            for (const FilmPixel& pixel : traced->film.pixels)
                for (const double sum : pixel.sum) EXPECT_GE(sum, 0) << "scene " << i;
        }
        for (std::size_t k = 0; k < one.film.pixels.size(); ++k)
            for (int c = 0; c < 3; ++c) {
                const double a = one.film.pixels[k].sum[c], b = two.film.pixels[k].sum[c];
                lit += a > 0;
                other_values += std::fabs(a - b) > 1e-5 * std::fabs(a);
                if (!fused) {
                    EXPECT_LE(std::fabs(a - b), 1e-5 * std::fabs(a))
                        << "scene " << i << ", pixel " << k;
                }
            }
    }
    note("RANDOM", "--", fmt::format("{} scenes, {} paths: other paths", scenes, paths),
         other_paths);
    note("RANDOM", "--", "sums that differ by more than 1e-5", other_values);
    EXPECT_LE(other_paths, paths / 200); // in a build that fuses: half a percent
    EXPECT_LE(other_values, paths / 200);
    EXPECT_GT(lit, paths / 2); // and the scenes are not mostly black
}

// Every surface reflects at most the light that arrives, so no path returns more than the sky's 1.
TEST(RandomScenes, NothingIsBrighterThanTheSky) {
    for (int i = 0; i < count(100, 3000); ++i) {
        Scene scene = Generator(10'000 + i).scene(true);
        for (const Lab& lab : labs())
            EXPECT_LE(largest_sample(trace(lab.number, scene, 1).film), 1 + 1e-5)
                << "scene " << i << ", lab " << lab.number;
    }
}

// The bound can be broken: by a sky that shines brighter.
TEST(RandomScenes, ABrighterSkyIsSeen) {
    Scene scene = Generator(10'000).scene(true);
    scene.environment_radiance *= 1.001f;
    EXPECT_GT(largest_sample(trace("02", scene, 1).film), 1 + 1e-5);
}

} // namespace

} // namespace raylab::app
