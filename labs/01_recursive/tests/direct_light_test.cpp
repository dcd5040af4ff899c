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

// Radiance that leaves the floor straight up at (x, 0, 0), by one shadow ray to light 0.
Vec3 from_floor(const Scene& scene, float x, Vec2 u, DirectLight strategy = DirectLight::light,
                float p_choice = 1) {
    const SceneView scene_view = view(scene);
    const Ray down = {Vec3(x, 3, 0), Vec3(0, -1, 0)};
    const SurfacePoint surface =
        surface_at<feature::all>(scene_view, down, {3, 0, Shape::plane, 0});
    PathRecord record;
    const Path path = {scene_view, scene.render, {}, record};
    return light_from(path, strategy, 0, p_choice, surface, Vec3(0.5f), -down.d, u);
}

Scene lamp_over_floor(const std::string& more = "") {
    return small_scene({floor_material, floor_plane + more,
                        R"({"kind": "point", "position": [0, 2, 0], "intensity": [10, 10, 10]})"});
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
                         "f |cos| L / pdf, and L of a point light is intensity / distance^2 "
                         "already"))
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

TEST(Task1_3, DiffuseReflectanceIsAlbedoOverPi) {
    for (const float cosine : {1.0f, 0.3f}) {
        const BsdfValue value =
            diffuse_value(Vec3(0.5f, 0.25f, 1), Vec3(std::sqrt(1 - cosine * cosine), 0, cosine));
        expect_vector("f cos of a diffuse surface of albedo (0.5, 0.25, 1)", value.f_cos,
                      Vec3(0.5f, 0.25f, 1) * (cosine * inv_pi), 1e-6, "f = albedo / pi");
        expect_near("density with which it chooses a direction", value.pdf, cosine * inv_pi, 1e-6,
                    "directions are drawn with density cos / pi");
    }
}

} // namespace

} // namespace raylab::lab01
