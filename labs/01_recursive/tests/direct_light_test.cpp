// Task 1.3: shadow rays, held against irradiances in closed form.
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/01_recursive/direct_light.h"

namespace raylab::lab01 {

namespace {

using namespace task;

const std::string floor_material =
    R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})";
const std::string floor_plane =
    R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor"})";

// Radiance that leaves plane 0 towards the ray, which meets it at t, by one shadow ray to light 0.
Vec3 from_plane(const Scene& scene, const Ray& ray, float t, Vec2 u, DirectLight strategy,
                float p_choice = 1, PathRecord* result = nullptr) {
    const SceneView scene_view = view(scene);
    const SurfacePoint surface = surface_at<feature::all>(scene_view, ray, {t, 0, Shape::plane, 0});
    PathRecord record;
    const Path path = {scene_view, scene.render, {}, record};
    const Vec3 light = light_from(path, strategy, 0, p_choice, surface, Vec3(0.5f), -ray.d, u);
    if (result) *result = record;
    return light;
}

// The same from (x, 0, 0) of the floor, straight up.
Vec3 from_floor(const Scene& scene, float x, Vec2 u, DirectLight strategy = DirectLight::light,
                float p_choice = 1) {
    return from_plane(scene, {Vec3(x, 3, 0), Vec3(0, -1, 0)}, 3, u, strategy, p_choice);
}

Scene lamp_over_floor(const std::string& more = "") {
    return small_scene({floor_material, floor_plane + more,
                        R"({"kind": "point", "position": [0, 2, 0], "intensity": [10, 10, 10]})"});
}

TEST(Task1_3, DiffuseReflectanceIsAlbedoOverPi) {
    for (const float cosine : {1.0f, 0.3f}) {
        const BsdfValue value =
            diffuse_value(Vec3(0.5f, 0.25f, 1), Vec3(std::sqrt(1 - cosine * cosine), 0, cosine));
        if (!expect_vector(
                fmt::format("f cos of a diffuse surface of albedo (0.5, 0.25, 1) at cos = {:g}",
                            cosine),
                value.f_cos, Vec3(0.5f, 0.25f, 1) * (cosine * inv_pi), 1e-6,
                cosine == 1 ? "f = albedo / pi" : "f_cos is f times the cosine, which is wi.z") ||
            !expect_near("density with which it chooses a direction", value.pdf, cosine * inv_pi,
                         1e-6, "directions are drawn with density cos / pi"))
            return;
    }
}

// The same floor and lamp, once with the normal (0, 0, 1), where the local frame is the world's.
TEST(Task1_3, AFloorMayFaceAnyWay) {
    const Scene wall = small_scene(
        {floor_material,
         R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "material": "floor"})",
         R"({"kind": "point", "position": [0, 0, 2], "intensity": [10, 10, 10]})"});
    const double lit = 0.5 / M_PI * 10 / 4;
    const double facing_z =
        from_plane(wall, {Vec3(0, 0, 3), Vec3(0, 0, -1)}, 3, Vec2(0.5f), DirectLight::light).x;
    const double facing_y = from_floor(lamp_over_floor(), 0, Vec2(0.5f)).x;
    if (std::fabs(facing_z - lit) < 1e-5) // else the next test tells what is wrong
        expect_near("radiance of a floor that faces y, lit as one that faces z", facing_y, facing_z,
                    1e-5,
                    "f is asked without the surface: evaluate(surface, ...) takes directions of "
                    "the world, evaluate(material, ...) those of the local frame");
}

// albedo / pi * I cos / d^2, cos = h / d.
TEST(Task1_3, APointLightLightsTheFloorByCosineAndDistance) {
    const Scene scene = lamp_over_floor();
    for (const float x : {0.0f, 1.0f, -3.0f}) {
        const double d2 = x * x + 4;
        if (!expect_near(fmt::format("radiance {:g} beside a point light of intensity 10 at "
                                     "height 2",
                                     std::fabs(x)),
                         from_floor(scene, x, Vec2(0.5f)).x,
                         0.5 / M_PI * 10 * 2 / (d2 * std::sqrt(d2)), 1e-5,
                         x == 0 ? "f |cos| L / pdf, and L of a point light is intensity / "
                                  "distance^2 already"
                                : "f |cos| L / pdf, and f_cos has the cosine already"))
            return;
    }
}

TEST(Task1_3, WhatStandsBetweenCastsAShadowAndWhatStandsBeyondDoesNot) {
    const auto sphere = [](double y) {
        return fmt::format(R"(, {{"kind": "sphere", "center": [0, {}, 0], "radius": 0.3,
                              "material": "floor"}})",
                           y);
    };
    expect_near("radiance behind a sphere in the light's way",
                from_floor(lamp_over_floor(sphere(1)), 0, Vec2(0.5f)).x, 0, 0,
                "the shadow ray asks whether anything lies between");
    expect_near("radiance with a sphere behind the light",
                from_floor(lamp_over_floor(sphere(2.5)), 0, Vec2(0.5f)).x,
                from_floor(lamp_over_floor(), 0, Vec2(0.5f)).x, 1e-7,
                "the shadow ray ends at the light");
}

TEST(Task1_3, AShadowRayIsCounted) {
    PathRecord record;
    from_plane(lamp_over_floor(), {Vec3(1, 3, 0), Vec3(0, -1, 0)}, 3, Vec2(0.5f),
               DirectLight::light, 1, &record);
    expect_equal("shadow rays counted of one that was sent", record.shadow_rays, 1,
                 "record_shadow_ray(path.record) is called once a shadow ray");
}

// A tilted floor through (0.3, 0.7, -0.2), whose points are off it by rounding, and a lamp.
Scene tilted_floor(const std::string& lamp_quad, const std::string& point_light) {
    return small_scene({floor_material + R"(, "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0],
                                              "emission": [3, 3, 3]})",
                        R"({"kind": "plane", "point": [0.3, 0.7, -0.2], "normal": [0.36, 0.8, 0.48],
                            "material": "floor"})" +
                            lamp_quad,
                        point_light});
}

// Of 64 points of the tilted floor, those that light 0 lights.
int lit_points(const Scene& scene) {
    const Vec3 n = normalize(Vec3(0.36f, 0.8f, 0.48f)), eye = Vec3(0.3f, 0.7f, -0.2f) + 3.0f * n;
    int lit = 0;
    for (int i = 0; i < 64; ++i) {
        const Vec3 aside(0.013f * i - 0.4f, 0.4f - 0.007f * i, 0.011f * i - 0.3f);
        const Vec3 d = normalize(aside - 3.0f * n);
        const Vec2 u((i % 8 + 0.37f) / 8, (i / 8 + 0.71f) / 8);
        const float t = -3 / dot(d, n);
        lit += from_plane(scene, {eye, d}, t, u, DirectLight::light).x > 0;
    }
    return lit;
}

TEST(Task1_3, NeitherTheSurfaceNorTheLampIsInTheWay) {
    const Scene point = tilted_floor(
        "", R"({"kind": "point", "position": [0.1, 3.3, 0.7], "intensity": [10, 10, 10]})");
    const Scene quad = tilted_floor(R"(, {"kind": "quad", "material": "lamp", "vertices":
        [[-0.7, 3.1, -0.9], [1.3, 3.3, -0.6], [1.1, 3.7, 1.4], [-0.9, 3.5, 1.1]]})",
                                    "");
    if (expect_equal("of 64 points of a tilted floor those that a point light above it lights",
                     lit_points(point), 64,
                     "the shadow ray starts under its own surface: spawn_ray_to() moves its ends "
                     "off both surfaces"))
        expect_equal("of 64 points of a tilted floor those that a tilted lamp above it lights",
                     lit_points(quad), 64,
                     "the shadow ray hits the lamp that it goes to: rounding makes `distance` too "
                     "long, spawn_ray_to() ends the ray before the lamp");
}

// The floor, a sphere and the point light, 4096 times smaller.
TEST(Task1_3, ASmallSceneHasTheSameShadows) {
    const Scene scene = small_scene(
        {floor_material, floor_plane + R"(, {"kind": "sphere", "center": [0, 0.000244140625, 0],
                             "radius": 0.00006103515625, "material": "floor"})",
         R"({"kind": "point", "position": [0, 0.00048828125, 0], "intensity": [10, 10, 10]})"});
    expect_near("radiance behind a sphere in the light's way, in a scene 4096 times smaller",
                from_floor(scene, 0, Vec2(0.5f)).x, 0, 0,
                "the shadow ray starts or ends a fixed length off its surfaces: how far rounding "
                "moves a point depends on the scene, and spawn_ray_to() knows");
}

// Under an even sky of radiance 2 a floor of albedo 1/2 reflects 1.
TEST(Task1_3, TheSkyIsALightWithoutADistance) {
    const std::string sky = R"({"kind": "environment", "radiance": [2, 2, 2]})";
    const Scene open = small_scene({floor_material, floor_plane, sky});
    const Scene covered = small_scene(
        {floor_material, floor_plane + R"(, {"kind": "sphere", "center": [0, 0, 0], "radius": 5,
                             "material": "floor"})",
         sky});
    double in_the_open = 0, under_cover = 0;
    for (int i = 0; i < 1024; ++i) {
        const Vec2 u((i % 32 + 0.5f) / 32, (i / 32 + 0.5f) / 32);
        in_the_open += from_floor(open, 0.5f, u).x / 1024;
        under_cover += from_floor(covered, 0.5f, u).x / 1024;
    }
    const std::string cause = "the sky is infinitely far: where sample.distance is infinity, the "
                              "shadow ray is spawn_ray() along sample.wi, without an end";
    if (expect_near("mean radiance of a floor of albedo 0.5 under an even sky of radiance 2",
                    in_the_open, 1, 0.02, cause))
        expect_near("the same within a closed sphere, which no sky can be seen from", under_cover,
                    0, 0, cause);
}

TEST(Task1_3, LightFromBelowDoesNotReachTheFloorsUpperSide) {
    const Scene scene =
        small_scene({floor_material, floor_plane,
                     R"({"kind": "point", "position": [0, -2, 0], "intensity": [10, 10, 10]})"});
    expect_near("radiance of a floor lit from below", from_floor(scene, 0.5f, Vec2(0.5f)).x, 0, 0,
                "light and viewer are on two sides of an opaque surface");
}

// A square lamp of side 2 at height 1, seen from under its middle. A point under the corner of a
// rectangle A x B (in units of its distance) has the form factor
//     F = (A / sqrt(1 + A^2) atan(B / sqrt(1 + A^2)) + B / sqrt(1 + B^2) atan(A / sqrt(1 + B^2))) /
//     2 pi
// and the point under the middle is a corner of four such rectangles.
Scene lamp_square() {
    return small_scene({floor_material + R"(, "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0],
                                              "emission": [3, 3, 3]})",
                        floor_plane + R"(, {"kind": "quad", "material": "lamp", "vertices":
                             [[-1, 1, -1], [1, 1, -1], [1, 1, 1], [-1, 1, 1]]})"});
}

TEST(Task1_3, AnAreaLightGivesItsFormFactor) {
    const Scene scene = lamp_square();
    const double form_factor = 4 * 2 * std::sqrt(0.5) * std::atan(std::sqrt(0.5)) / (2 * M_PI);
    double sum = 0;
    for (int i = 0; i < 32; ++i)
        for (int j = 0; j < 32; ++j)
            sum += from_floor(scene, 0, Vec2((i + 0.5f) / 32, (j + 0.5f) / 32)).x;
    expect_near("mean radiance under a square lamp of radiance 3", sum / (32 * 32),
                0.5 * 3 * form_factor, 2e-3, "f |cos| L / pdf: is one factor missing, or twice?");
    const double one = from_floor(scene, 0, Vec2(0.3f)).x;
    expect_near("radiance if the light is chosen every other time",
                from_floor(scene, 0, Vec2(0.3f), DirectLight::light, 0.5f).x, 2 * one, 1e-5,
                "the density is that of choosing the light times that of the point on it");
}

TEST(Task1_3, OnlyShadowRaysFindAPointLight) {
    const Scene scene = lamp_over_floor();
    const double alone = from_floor(scene, 1, Vec2(0.5f)).x;
    for (const DirectLight strategy : {DirectLight::bsdf, DirectLight::mis})
        if (!expect_near(fmt::format("radiance from a point light with DirectLight::{}, over that "
                                     "with DirectLight::light",
                                     strategy == DirectLight::bsdf ? "bsdf" : "mis"),
                         from_floor(scene, 1, Vec2(0.5f), strategy).x / alone, 1, 1e-5,
                         "no direction of the surface can hit a point light (sample.delta): "
                         "whatever the strategy, its shadow ray is sent and weighs 1"))
            return;
}

TEST(Task1_3, LightAndSurfaceSharingTheWorkUseThePowerHeuristic) {
    const Scene scene = lamp_square();
    const Vec2 u(0.3f, 0.8f);
    const LightSample sample = sample_light<feature::all>(view(scene), 0, Vec3(0), u);
    const double p = sample.pdf, q = sample.wi.y / M_PI;
    const double alone = from_floor(scene, 0, u).x;
    expect_near("weight of a light sample under multiple importance sampling",
                from_floor(scene, 0, u, DirectLight::mis).x / alone, p * p / (p * p + q * q), 1e-4,
                "w = p^2 / (p^2 + q^2), p the light's density and q the surface's");
    expect_near("radiance from an area light that only the surface may sample",
                from_floor(scene, 0, u, DirectLight::bsdf).x, 0, 0,
                "with DirectLight::bsdf only point lights are asked directly");
}

} // namespace

} // namespace raylab::lab01
