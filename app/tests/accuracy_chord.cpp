// FURN-CHORD: how far is it from hit to hit in a closed sphere? 4 R / 3 in the mean.
//
// Diffuse light leaves a point of a sphere's wall at angle t from the normal with density 2 cos t
// sin t and flies 2 R cos t: 2 R * 2/3. The furnace's radiance is exact however often a bounce hits
// its own starting point, since every hit adds the same; the mean distance is not.
#include "app/tests/accuracy.h"
#include "common/sampling/sampler.h"
#include "common/trace/offset.h"
#include "labs/01_recursive/camera.h"
#include "labs/01_recursive/scatter.h"

namespace raylab::app {

namespace {

// The way a bounce leaves its surface.
using Spawn = Ray (*)(const Ray& before, const Hit& hit, const SurfacePoint& surface, Vec3 wi);

Ray robust(const Ray&, const Hit&, const SurfacePoint& surface, Vec3 wi) {
    return spawn_ray(surface, wi);
}

// The naive variant: start where the ray ended, and skip the first `epsilon` of the way.
constexpr float epsilon = 1e-4f;
Ray from_fixed_epsilon(const Ray& before, const Hit& hit, const SurfacePoint&, Vec3 wi) {
    return {before(hit.t) + epsilon * wi, wi};
}

BsdfSample scatter(const std::string& lab, const Material& m, Vec3 wo, float u_lobe, Vec2 u) {
    return lab == "01" ? lab01::scatter(m, m.reflectance, wo, u_lobe, u)
                       : sample_bsdf<feature::all>(m, m.reflectance, wo, u_lobe, u);
}

// The lab's path, bounce by bounce, from the lab's own pieces. Calls leg(t) from the second ray on.
template <class Leg>
PathRecord walk(const std::string& lab, const Scene& scene, int pixel, int sample, Spawn spawn,
                const Leg& leg) {
    const SceneView v = view(scene);
    const Sampler sampler = {scene.render.sampler, scene.render.seed,
                             static_cast<std::uint32_t>(pixel), static_cast<std::uint32_t>(sample)};
    const int width = v.camera.width;
    Ray ray = lab01::camera_ray(v.camera, pixel % width, pixel / width,
                                sampler.get_2d(dimension::film), sampler.get_2d(dimension::lens));
    PathRecord record;
    for (int bounce = 0; bounce < scene.render.max_depth; ++bounce) {
        const Hit hit = closest(lab, v, ray);
        record_hit(record, hit.id);
        if (bounce > 0) leg(hit.t);
        if (!hit.found()) break;
        const SurfacePoint surface = surface_at<feature::all>(v, ray, hit);
        const BsdfSample scattered =
            scatter(lab, v.materials[surface.material], surface.shading.to_local(-ray.d),
                    sampler.get_1d(bounce_dimension(bounce, dimension::lobe_roulette)),
                    sampler.get_2d(bounce_dimension(bounce, dimension::direction)));
        ray = spawn(ray, hit, surface, surface.shading.to_world(scattered.wi));
    }
    return record;
}

Scene room(const std::string& shape, double size, int depth, int side) {
    return parse({.camera = camera(size * DVec3(0.3, 0.2, 0.1), DVec3(size, 0, 0), 60),
                  .materials = R"("wall": )" + diffuse(DVec3(0.9)),
                  .shapes = shape,
                  .render = fmt::format(
                      R"("max_depth": {}, "roulette": false, "sampler": "independent")", depth),
                  .width = side,
                  .height = side});
}

struct Chords {
    test::Mean relative;  // to 4 R / 3
    double self_hits = 0; // the share of legs below 1e-5 R: one in 4e10 is that short
};

Chords chords(const std::string& lab, double radius, int paths, Spawn spawn) {
    const int side = 32;
    const Scene scene = room(sphere(DVec3(0), radius, "wall"), radius, 101, side);
    Chords found;
    for (int path = 0; path < paths; ++path)
        walk(lab, scene, path % (side * side), path / (side * side), spawn, [&](double t) {
            found.relative.add(std::isfinite(t) ? t / (4 * radius / 3) : 0);
            found.self_hits += t < 1e-5 * radius;
        });
    found.self_hits /= found.relative.n;
    return found;
}

TEST_P(EachLab, TheWalkIsTheLabsPath) {
    const Scene scene = room(box({-1, -1, -2}, {1, 1.5, 1}, "wall"), 1, fused ? 6 : 40, 16);
    const Traced traced = trace(GetParam(), scene, 1);
    int different = 0;
    for (int pixel = 0; pixel < 256; ++pixel) {
        const PathRecord record = walk(GetParam(), scene, pixel, 0, robust, [](double) {});
        different += record.hits != traced.records[pixel].hits;
    }
    EXPECT_LE(different, fused ? 1 : 0);
}

TEST_P(EachLab, FurnChordIsFourThirdsOfTheRadiusAtEverySize) {
    for (const double radius : {1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6}) {
        const Chords ours = chords(GetParam(), radius, count(1000, 20000), robust);
        // Legs are independent: the length of a leg does not depend on where on the sphere the path
        // is.
        const double tolerance = 1e-3 + 4 * ours.relative.standard_error();
        figure("FURN-CHORD", GetParam(), fmt::format("R = {}: mean chord off, in parts", radius),
               std::fabs(ours.relative.mean() - 1), tolerance);
        figure("FURN-CHORD", GetParam(), fmt::format("R = {}: self hits", radius), ours.self_hits,
               0);
    }
    const Chords naive = chords(GetParam(), 1e6, count(200, 2000), from_fixed_epsilon);
    note("FURN-CHORD", GetParam(), "R = 1e6, fixed epsilon: mean chord / R",
         naive.relative.mean() * 4 / 3);
    note("FURN-CHORD", GetParam(), "R = 1e6, fixed epsilon: self hits", naive.self_hits);
    EXPECT_LT(naive.relative.mean(), 0.9);
}

INSTANTIATE_TEST_SUITE_P(Labs, EachLab, testing::ValuesIn(lab_numbers()), lab_name);

} // namespace

} // namespace raylab::app
