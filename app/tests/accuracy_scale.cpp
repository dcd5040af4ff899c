// POW2-SCALE, OFFSET: an image depends neither on the unit of length nor, beyond the resolution of
// float, on the place of the origin.
//
// Multiplying every length by 2^k is exact in binary arithmetic. If no bit of the image changes,
// nothing in the renderer compares a length with a constant.
#include "app/tests/accuracy.h"
#include "common/trace/offset.h"

namespace raylab::app {

namespace {

// --- POW2-SCALE -------------------------------------------------------------------------------

// The scene with every length times 2^k. A point light's radiance falls with the distance squared,
// so its intensity grows with the square.
Scene scaled(Scene scene, int k) {
    const float s = std::ldexp(1.0f, k);
    scene.camera.position *= s;
    scene.camera.lens_radius *= s;
    scene.camera.focus_distance *= s;
    for (Sphere& sphere : scene.spheres) sphere.center *= s, sphere.radius *= s;
    scene.sphere_groups = group_spheres(scene.spheres);
    for (Plane& plane : scene.planes) plane.point *= s;
    for (Quad& quad : scene.quads) {
        for (Vec3& v : quad.v) v *= s;
        quad = make_quad(quad.v, quad.tags);
    }
    scene.quad_groups = group_quads(scene.quads);
    for (Triangle& triangle : scene.triangles)
        for (Vec3& v : triangle.v) v *= s;
    for (TriangleRun& run : scene.runs) run.bounds.low *= s, run.bounds.high *= s;
    for (Light& light : scene.lights) light.position *= s, light.intensity *= s * s;
    return scene;
}

Scene small(const std::string& name, int side) {
    Scene scene = load_scene(find_scene(name));
    const double shrink = 1.0 * side / std::max(scene.camera.width, scene.camera.height);
    set_film_size(scene.camera, std::max(1, static_cast<int>(scene.camera.width * shrink)),
                  std::max(1, static_cast<int>(scene.camera.height * shrink)));
    scene.render.max_depth = std::min(scene.render.max_depth, 16);
    return scene;
}

TEST_P(EachLab, Pow2ScaleChangesNoBitOfAnyBundledScene) {
    std::vector<int> powers = {-20, -7, 1, 20};
    if (count(0, 1)) {
        powers.clear();
        for (int k = -20; k <= 20; ++k) powers.push_back(k);
    }
    for (const std::string& name : bundled_scenes()) {
        const Scene scene = small(name, count(12, 48));
        const Film film = trace(GetParam(), scene, 2).film;
        double worst = 0;
        for (const int k : powers)
            worst = std::max(worst,
                             differing_pixels(trace(GetParam(), scaled(scene, k), 2).film, film));
        figure("POW2-SCALE", GetParam(), fmt::format("{}: share of pixels that change", name),
               worst, 0);
    }
}

// The comparison can fail: a lens, or a light, that keeps its size while the scene grows.
TEST_P(EachLab, Pow2ScaleSeesOneLengthLeftOut) {
    const Scene lens = small("depth_of_field", 32);
    Scene grown = scaled(lens, 1);
    grown.camera.lens_radius = lens.camera.lens_radius;
    EXPECT_GT(differing_pixels(trace(GetParam(), grown, 1).film, trace(GetParam(), lens, 1).film),
              0.1);

    const Scene box = small("cornell_spheres", 32);
    grown = scaled(box, 1);
    grown.spheres[0].radius = box.spheres[0].radius;
    grown.sphere_groups = group_spheres(grown.spheres);
    EXPECT_GT(differing_pixels(trace(GetParam(), grown, 1).film, trace(GetParam(), box, 1).film),
              0.01);
}

// What an absolute epsilon does to bounces: the next hit's distance, with the exponent taken out.
TEST(Pow2Scale, AFixedEpsilonChangesBits) {
    const Scene scene = small("cornell_spheres", 48);
    const auto second_hits = [](const Scene& s, int k, bool naive) {
        const SceneView v = view(s);
        std::vector<float> t;
        for (int i = 0; i < v.camera.width * v.camera.height; ++i) {
            const Ray ray = generate_ray(v.camera, i % v.camera.width, i / v.camera.width,
                                         Vec2(0.5f), Vec2(0.5f));
            const Hit hit = intersect<feature::all>(v, ray);
            if (!hit.found()) continue;
            const SurfacePoint surface = surface_at<feature::all>(v, ray, hit);
            const Vec3 wi = surface.shading.to_world(Vec3(0.6f, 0, 0.8f));
            const Ray next = naive ? Ray{ray(hit.t) + 1e-4f * wi, wi} : spawn_ray(surface, wi);
            t.push_back(std::ldexp(intersect<feature::all>(v, next).t, -k));
        }
        return t;
    };
    const auto differing = [&](bool naive) {
        const std::vector<float> a = second_hits(scene, 0, naive);
        const std::vector<float> b = second_hits(scaled(scene, -20), -20, naive);
        std::size_t differ = a.size() != b.size() ? a.size() : 0;
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) differ += a[i] != b[i];
        return static_cast<double>(differ) / a.size();
    };
    figure("POW2-SCALE", "--", "k = -20: second hits that change", differing(false), 0,
           differing(true));
}

// --- OFFSET -----------------------------------------------------------------------------------

// A unit sphere whose centre is X away from the origin, seen from 3 beside it: how far from the
// sphere do its hit points lie? An ulp of X is the resolution of the coordinates.
TEST_P(EachLab, OffsetHitPointsLieOnTheirSurface) {
    for (const double x : {1e2, 1e3, 1e4, 1e5, 1e6, 1e7}) {
        const DVec3 place(Vec3(static_cast<float>(x), 1, -2));
        const Scene scene = parse({.camera = camera(place + DVec3(3, 0, 0), place, 30),
                                   .materials = R"("m": )" + diffuse(DVec3(0.5)),
                                   .shapes = sphere(place, 1, "m")});
        const SceneView v = view(scene);
        const double ulp = std::nextafter(static_cast<float>(x), infinity) - static_cast<float>(x);
        test::Random random(47);
        double worst = 0, naive = 0;
        for (int i = 0; i < count(5000, 100'000); ++i) {
            const Ray ray = generate_ray(v.camera, i % 8, i / 8 % 8, random.square(), Vec2(0.5f));
            const Hit hit = closest(GetParam(), v, ray);
            if (!hit.found()) continue;
            const auto residue = [&](Vec3 p) {
                return std::fabs(glm::length(DVec3(p) - place) - 1);
            };
            worst = std::max(worst, residue(surface_at<feature::all>(v, ray, hit).p));
            naive = std::max(naive, residue(ray(hit.t)));
        }
        figure("OFFSET", GetParam(), fmt::format("X = {}: residue, ulp(X) {:.1g}", x, ulp), worst,
               ulp + 1e-6);
        note("OFFSET", GetParam(), "  o + t d", naive);
    }
}

// A closed unit room far from the origin: its corners are exact, its light the same to rounding.
TEST_P(EachLab, OffsetAFurnaceFarAwayLosesNothing) {
    for (const double x : {0.0, 1024.0, 65536.0, 1048576.0}) {
        const DVec3 place(x, -x / 2, 0);
        const Traced traced = trace(
            GetParam(),
            parse({.camera = camera(place + DVec3(0.25, 0.125, 0), place + DVec3(1, 0, 0), 60),
                   .materials = R"("wall": )" + diffuse(DVec3(0.9), DVec3(1)),
                   .shapes = box(place - DVec3(1), place + DVec3(1), "wall"),
                   .render = R"("max_depth": 50, "roulette": false, "direct_light": "bsdf")",
                   .width = 16,
                   .height = 16}),
            count(4, 100));
        const double a = 0.9f;
        figure("OFFSET", GetParam(), fmt::format("box at X = {}: escapes", x),
               paths_that(traced, PathEnd::escaped), 0);
        figure("OFFSET", GetParam(), fmt::format("box at X = {}: worst pixel", x),
               worst_pixel(traced.film, (1 - std::pow(a, 50)) / (1 - a)), 1e-5);
    }
}

// A turned cube, as a box and as twelve triangles: its corners are rounded, more so the farther
// away it is, and in one coordinate more than in the others.
TEST_P(EachLab, OffsetATurnedFurnaceFarAwayLosesNothing) {
    for (const bool is_mesh : {false, true})
        for (const double size : {1e-4, 1.0})
            for (const double x : {0.0, 1e4, 65536.0}) {
                const std::string turned = fmt::format(R"(, "transform": {{"scale": {}, "rotate":
                        [{{"axis": [1, 2, 3], "angle_deg": 33}}], "translate": [{}, 0, 0]}}}})",
                                                       size, size * x);
                std::string shapes = box(DVec3(-1), DVec3(1), "wall");
                shapes.back() = ' ';
                shapes += turned;
                if (is_mesh) {
                    shapes.clear();
                    constexpr int faces[12][3] = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5},
                                                  {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                                  {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
                    const auto corner = [](int i) {
                        return 2.0 * DVec3(i & 1, i >> 1 & 1, i >> 2) - 1.0;
                    };
                    for (const auto& f : faces) {
                        if (!shapes.empty()) shapes += ", ";
                        shapes += triangle(corner(f[0]), corner(f[1]), corner(f[2]), "wall");
                        shapes.back() = ' ';
                        shapes += turned;
                    }
                }
                const DVec3 place(size * x, 0, 0);
                const Traced traced = trace(
                    GetParam(),
                    parse(
                        {.camera = camera(place + size * DVec3(0.1, 0.2, 0.3),
                                          place + size * DVec3(0.5, 0.6, 0.9), 100),
                         .materials = R"("wall": )" + diffuse(DVec3(1), DVec3(1)),
                         .shapes = shapes,
                         .render = R"("max_depth": 200, "roulette": false, "direct_light": "bsdf")",
                         .width = 16,
                         .height = 16}),
                    count(4, 100));
                const std::string what = fmt::format("{} of {} turned, {} sizes away",
                                                     is_mesh ? "mesh" : "box", size, x);
                figure("OFFSET", GetParam(), what + ": escapes",
                       paths_that(traced, PathEnd::escaped), 0);
                figure("OFFSET", GetParam(), what + ": worst pixel", worst_pixel(traced.film, 200),
                       0);
            }
}

// Far away in x alone, the rounding of x is no reason to move a point in z. A small lamp at height
// h above the seam of two floors gives what E / pi = L (r / h)^2 says.
TEST_P(EachLab, OffsetAlongOneAxisDoesNotBlurTheOthers) {
    for (const double x : {0.0, 16384.0, 65536.0}) {
        const Scene scene = parse(
            {.camera = camera({x, 0.03, 0.001}, {x, 0, 0.001}, 0.5),
             .materials = R"("floor": )" + diffuse(DVec3(1)) + R"(, "lamp": )" +
                          diffuse(DVec3(0), DVec3(100)),
             .shapes = quad({x - 4, 0, -4}, {x - 4, 0, 0}, {x + 4, 0, 0}, {x + 4, 0, -4}, "floor") +
                       ", " +
                       quad({x - 4, 0, 0}, {x - 4, 0, 4}, {x + 4, 0, 4}, {x + 4, 0, 0}, "floor") +
                       ", " + sphere({x, 0.05, 0}, 0.01, "lamp"),
             .render = R"("max_depth": 2, "sampler": "independent")"});
        for (const char* how : {"light", "bsdf", "mis"}) {
            Scene asked = scene;
            asked.render.direct_light = how == std::string("light")  ? DirectLight::light
                                        : how == std::string("bsdf") ? DirectLight::bsdf
                                                                     : DirectLight::mis;
            const Estimate found = estimate(trace(GetParam(), asked, count(200, 5000)).film);
            const double truth = 100 * 0.01 * 0.01 / (0.05 * 0.05);
            // The height above x is known to half an ulp of x: up to 1 % of the light at 65536.
            figure("OFFSET", GetParam(), fmt::format("lamp above a seam, x = {}, {}", x, how),
                   std::fabs(found.mean / truth - 1), 4 * found.error / truth + 0.01);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
