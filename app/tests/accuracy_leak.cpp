// BOX-CORNER, TRI-EDGE, SELF-CONVEX, GAP-LEAK: no ray leaves a closed room, and no ray meets the
// surface that it starts on.
#include "app/tests/accuracy.h"
#include "app/tests/icosphere.h"
#include "common/load/transform.h"
#include "common/trace/offset.h"

namespace raylab::app {

namespace {

long long bounces(const Traced& traced) {
    long long sum = 0;
    for (const PathRecord& record : traced.records) sum += record.length;
    return sum;
}

// --- BOX-CORNER -------------------------------------------------------------------------------

constexpr DVec3 low(-1, -1, -2), high(1, 1.5, 1);

// 1e-6 off each of the 8 corners and of the 12 edges' middles.
std::vector<DVec3> places_by_corners_and_edges() {
    std::vector<DVec3> places;
    for (int i = 0; i < 27; ++i) {
        const int at[3] = {i % 3, i / 3 % 3, i / 9}; // 0: by low, 1: by high, 2: in the middle
        if ((at[0] == 2) + (at[1] == 2) + (at[2] == 2) > 1) continue;
        DVec3 p;
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = at[axis] == 0   ? low[axis] + 1e-6
                      : at[axis] == 1 ? high[axis] - 1e-6
                                      : 0.5 * (low[axis] + high[axis]) + 0.1;
        places.push_back(p);
    }
    return places;
}

TEST_P(EachLab, BoxCornerNothingEscapes) {
    const glm::dmat3 turn = rotation(glm::normalize(DVec3(1, 2, 3)), glm::radians(40.0));
    const std::string turned =
        R"(, "transform": {"rotate": [{"axis": [1, 2, 3], "angle_deg": 40}]})";
    for (const bool is_turned : {false, true}) {
        long long escaped = 0, legs = 0, through_crack = 0;
        for (const DVec3& place : places_by_corners_and_edges()) {
            const DVec3 position = is_turned ? turn * place : place;
            const DVec3 middle = is_turned ? turn * (0.5 * (low + high)) : 0.5 * (low + high);
            Scene scene =
                parse({.camera = camera(position, middle, 100),
                       .materials = R"("wall": )" + diffuse(DVec3(1), DVec3(1)),
                       .shapes = box(low, high, "wall", is_turned ? turned : ""),
                       .render = R"("max_depth": 100, "roulette": false, "direct_light": "bsdf")",
                       .width = 16,
                       .height = 16});
            const Traced traced = trace(GetParam(), scene, count(2, 40));
            escaped += paths_that(traced, PathEnd::escaped);
            legs += bounces(traced);
            for (Vec3& v : scene.quads[0].v) v.x -= 1e-4f; // the planted error: a crack
            scene.quads[0] = make_quad(scene.quads[0].v, scene.quads[0].tags);
            scene.quad_groups = group_quads(scene.quads);
            through_crack += paths_that(trace(GetParam(), scene, 1), PathEnd::escaped);
        }
        figure("BOX-CORNER", GetParam(),
               fmt::format("{}escapes in {} bounces", is_turned ? "turned, " : "", legs),
               static_cast<double>(escaped), 0, static_cast<double>(through_crack));
    }
}

// --- TRI-EDGE ---------------------------------------------------------------------------------

// Moller and Trumbore 1997 with strict bounds, the naive variant.
bool moller_trumbore(const Triangle& triangle, const Ray& ray) {
    const Vec3 e1 = triangle.v[1] - triangle.v[0], e2 = triangle.v[2] - triangle.v[0];
    const Vec3 p = cross(ray.d, e2), s = ray.o - triangle.v[0], q = cross(s, e1);
    const float det = dot(e1, p), u = dot(s, p) / det, v = dot(ray.d, q) / det;
    return u > 0 && v > 0 && u + v < 1 && dot(e2, q) / det > 0;
}

// From inside a closed mesh of 5120 triangles at its vertices, its edges' middles and random points
// of its edges: each ray must meet something.
TEST_P(EachLab, TriEdgeNoRayLeavesAClosedMeshThroughAnEdge) {
    for (const double radius : {1e-3, 1.0, 1e4}) {
        Scene scene = parse({.camera = camera({0, 0, 0}, {1, 0, 0}, 60),
                             .materials = R"("wall": )" + diffuse(DVec3(0.5)),
                             .shapes = ""});
        add_icosphere(scene, 4, radius, 0, false);
        const SceneView v = view(scene);
        test::Random random(41);
        const int rays = count(20'000, 1'000'000), naive_rays = 500;
        int leaks = 0, naive_leaks = 0;
        for (int i = 0; i < rays; ++i) {
            const Triangle& face = scene.triangles[i % scene.triangles.size()];
            const float along = i % 3 == 0 ? 0 : i % 3 == 1 ? 0.5f : random.u();
            const Vec3 target = face.v[0] + along * (face.v[1] - face.v[0]);
            const Vec3 o = static_cast<float>(0.5 * radius) * random.direction();
            const Ray ray = {o, normalize(target - o)};
            leaks += !closest(GetParam(), v, ray).found();
            if (i >= naive_rays) continue;
            naive_leaks += std::none_of(scene.triangles.begin(), scene.triangles.end(),
                                        [&](const Triangle& t) { return moller_trumbore(t, ray); });
        }
        figure("TRI-EDGE", GetParam(), fmt::format("R = {}: leaks of {} rays", radius, rays), leaks,
               0, naive_leaks * (1.0 * rays / naive_rays));
    }
}

// The same mesh rendered: a furnace of 320 triangles loses no path.
TEST_P(EachLab, TriEdgeAFurnaceOfTrianglesLosesNoPath) {
    Scene scene = parse({.camera = camera({0.3, 0.2, 0.1}, {1, 0, 0}, 90),
                         .materials = R"("wall": )" + diffuse(DVec3(0.9), DVec3(1)),
                         .shapes = "",
                         .render = R"("max_depth": 50, "roulette": false, "direct_light": "bsdf")",
                         .width = 16,
                         .height = 16});
    add_icosphere(scene, 2, 1, 0, false);
    // Emission counts for shapes that belong to a light; which one matters only to light sampling.
    for (Triangle& t : scene.triangles) t.tags.light = 0;
    scene.lights.push_back({LightKind::triangle, 0, Vec3(0), Vec3(0)});
    const Traced traced = trace(GetParam(), scene, count(4, 200));
    const double a = 0.9f, truth = (1 - std::pow(a, 50)) / (1 - a);
    figure("TRI-EDGE", GetParam(), fmt::format("furnace, escapes in {} bounces", bounces(traced)),
           paths_that(traced, PathEnd::escaped), 0);
    figure("TRI-EDGE", GetParam(), "furnace, worst pixel", worst_pixel(traced.film, truth), 1e-5);
    scene.triangles.pop_back(); // the planted error: a hole
    --scene.runs.back().count;
    EXPECT_GT(paths_that(trace(GetParam(), scene, 1), PathEnd::escaped), 0);
}

// --- SELF-CONVEX ------------------------------------------------------------------------------

// Rays that leave a sphere or a triangle on the side they came from, half of them grazing with
// cosines down to 1e-4, must not meet it again.
TEST_P(EachLab, SelfConvexNoRayMeetsWhatItLeaves) {
    for (const double size : {1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6}) {
        const DVec3 center = size * DVec3(0.7, -0.4, 0.2);
        for (const auto& [name, shape] :
             {std::pair<std::string, std::string>{"sphere", sphere(center, size, "m")},
              {"triangle",
               triangle(center + size * DVec3(-9, -8, 1), center + size * DVec3(9, -7, 2),
                        center + size * DVec3(0, 11, -1), "m")}}) {
            const Scene scene = parse({.camera = camera({0, 0, 9 * size}, {0, 0, 0}, 30),
                                       .materials = R"("m": )" + diffuse(DVec3(1)),
                                       .shapes = shape});
            const SceneView v = view(scene);
            test::Random random(43);
            const int rays = count(5000, 100'000);
            int again = 0, naive_again = 0;
            for (int i = 0; i < rays; ++i) {
                const DVec3 target = center + 0.6 * size * DVec3(random.direction());
                const Vec3 o(center + 9.0 * size * DVec3(random.direction()));
                const Ray ray = {o, normalize(Vec3(target) - o)};
                const Hit hit = closest(GetParam(), v, ray);
                if (!hit.found()) continue; // in the triangle's plane
                const SurfacePoint surface = surface_at<feature::all>(v, ray, hit);
                const double cosine = i % 2 ? random.between(0.01f, 1.0f)
                                            : std::pow(10.0, random.between(-4.0f, 0.0f));
                const double sine = std::sqrt(1 - cosine * cosine), phi = 2 * M_PI * random.u();
                Vec3 wi = Frame::around(surface.ng)
                              .to_world(Vec3(sine * std::cos(phi), sine * std::sin(phi), cosine));
                if (dot(ray.d, surface.ng) > 0) wi -= 2 * dot(wi, surface.ng) * surface.ng;
                again += closest(GetParam(), v, spawn_ray(surface, wi)).found();
                naive_again += closest(GetParam(), v, {ray(hit.t) + 1e-4f * wi, wi}).found();
            }
            figure("SELF-CONVEX", GetParam(), fmt::format("{}, S = {}: re-hits", name, size), again,
                   0, size >= 1e4 ? std::optional<double>(naive_again) : std::nullopt);
        }
    }
}

// Rendered: under an open sky a path touches a convex shape once and escapes.
TEST_P(EachLab, SelfConvexPathsTouchASphereOnce) {
    for (const double size : {1e-4, 1.0, 1e6}) {
        const Scene scene =
            parse({.camera = camera(size * DVec3(0, 0, 3), {0, 0, 0}, 45),
                   .materials = R"("m": )" + diffuse(DVec3(1)),
                   .shapes = sphere({0, 0, 0}, size, "m"),
                   .lights = white_sky,
                   .render = R"("max_depth": 5, "roulette": false, "direct_light": "bsdf")",
                   .width = 64,
                   .height = 64});
        const Traced traced = trace(GetParam(), scene, count(2, 64));
        const auto longer = std::count_if(traced.records.begin(), traced.records.end(),
                                          [](const PathRecord& r) { return r.length > 2; });
        figure("SELF-CONVEX", GetParam(),
               fmt::format("rendered sphere, S = {}: longer paths", size),
               static_cast<double>(longer), 0);
        figure("SELF-CONVEX", GetParam(), fmt::format("rendered sphere, S = {}: furnace off", size),
               worst_pixel(traced.film, 1), 1e-6);
    }
}

// --- GAP-LEAK ---------------------------------------------------------------------------------

// A floor under a black lid at height g, a white sky above the lid: the camera in between must see
// black. An offset larger than the gap starts rays and shadow rays above the lid.
TEST_P(EachLab, GapLeakALidCloseAboveTheFloorKeepsTheSkyOut) {
    for (const double gap : {1e-2, 1e-3, 1e-4, 1e-5})
        for (const double size : {1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6}) {
            const double g = gap * size;
            const DVec3 eye = size * DVec3(0.3, gap / 2, 0.2);
            const Scene scene = parse({.camera = camera(eye, {eye.x + g, 0, eye.z}, 60),
                                       .materials = R"("floor": )" + diffuse(DVec3(1)) +
                                                    R"(, "lid": )" + diffuse(DVec3(0)),
                                       .shapes = plane({0, 0, 0}, {0, 1, 0}, "floor") + ", " +
                                                 plane({0, g, 0}, {0, 1, 0}, "lid"),
                                       .lights = white_sky,
                                       .render = R"("max_depth": 3, "roulette": false)",
                                       .width = 16,
                                       .height = 16});
            const Film film = trace(GetParam(), scene, count(4, 400)).film;
            const auto lit = std::count_if(film.pixels.begin(), film.pixels.end(),
                                           [](const FilmPixel& p) { return p.sum[0] != 0; });

            // The naive variant: of the floor's rays, how many start above the lid?
            test::Random random(44);
            double leaks = 0;
            for (int i = 0; i < 1000; ++i) {
                const Vec3 p(size * random.u(), 0, size * random.u());
                const Vec3 wi = sample_cosine_hemisphere(random.square());
                const Vec3 up(wi.x, wi.z, wi.y);
                leaks += !closest(GetParam(), view(scene), {p + 1e-4f * up, up}).found();
            }
            figure("GAP-LEAK", GetParam(), fmt::format("S = {}, gap {} S: lit pixels", size, gap),
                   static_cast<double>(lit), 0,
                   g < 5e-5 ? std::optional(leaks / 1000) : std::nullopt);
        }
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
