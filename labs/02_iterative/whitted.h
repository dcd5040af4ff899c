// Whitted's ray tracer as a loop. Whitted, An Improved Illumination Model for Shaded Display, 1980.
//
// A path is a line, so its loop needs only the throughput. Whitted's rays form a *tree*: glass
// sends one ray on and one back. A loop over a tree needs a stack of the rays still to be traced;
// each carries its own throughput. Taking the newest first (depth first), the stack never holds
// more than one ray a level.
#pragma once

#include "common/scene/settings.h"
#include "common/task/not_implemented.h"
#include "common/trace/texture.h"
#include "common/transport/direct_light.h"
#include "common/transport/specular_split.h"

namespace raylab::lab02 {

// A ray still to be traced. node numbers the tree: root 1, reflection 2n, refraction 2n + 1; it
// stands in for the bounce in the random numbers' dimensions, the same in every lab.
struct PendingRay {
    Ray ray;
    Vec3 throughput;
    int depth; // surfaces touched before
    std::uint32_t node;
};

// Shadow rays to every light.
template <Features F>
HD Vec3 light_from_all(const SceneView& scene, const SurfacePoint& surface, Vec3 reflectance,
                       Vec3 wo, const Sampler& sampler, std::uint32_t node, PathRecord& record) {
    Vec3 sum(0);
    for (int light = 0; light < scene.lights.size; ++light) {
        const Vec2 u = sampler.get_2d(shadow_ray_dimension(node, light));
        sum +=
            light_from<F>(scene, DirectLight::light, light, 1, surface, reflectance, wo, u, record);
    }
    return sum;
}

template <Features F>
HD Vec3 trace_whitted(const SceneView& scene, const RenderSettings& settings,
                      const Sampler& sampler, Ray camera_ray, PathRecord& record) {
    //[ task 2.1
    Vec3 radiance(0);
    PendingRay stack[max_whitted_depth + 1];
    int pending = 0;
    stack[pending++] = {camera_ray, Vec3(1), 0, 1};
    record = {};
    record.end = PathEnd::absorbed;

    while (pending > 0) {
        const PendingRay now = stack[--pending];
        const Hit hit = intersect<F>(scene, now.ray);
        record_hit(record, hit.id);
        if (!hit.found()) {
            radiance +=
                now.throughput * escaped_light<F>(scene, DirectLight::light, now.ray, delta_pdf);
            continue;
        }
        const SurfacePoint surface = surface_at<F>(scene, now.ray, hit);
        const Material& material = scene.materials[surface.material];
        const Vec3 reflectance = reflectance_at<F>(scene, material, surface);
        const Vec3 wo = -now.ray.d;
        radiance += now.throughput * material.emission;
        if (now.depth + 1 == settings.max_depth) continue;

        if (!is_specular<F>(material)) {
            radiance += now.throughput * light_from_all<F>(scene, surface, reflectance, wo, sampler,
                                                           now.node, record);
            continue;
        }
        // The refracted ray is pushed first, so that the reflected one is traced first, as the
        // recursive tracer does.
        const SpecularSplit split = split_specular<F>(surface, material, reflectance, wo);
        if (split.refracts)
            stack[pending++] = {spawn_ray(surface, split.refracted),
                                now.throughput * split.refracted_weight, now.depth + 1,
                                2 * now.node + 1};
        stack[pending++] = {spawn_ray(surface, split.reflected),
                            now.throughput * split.reflected_weight, now.depth + 1, 2 * now.node};
    }
    return radiance;
    //| not_implemented("2.1", "trace_whitted()");
    //| record_hit(record, -1);
    //| return Vec3(0);
    //]
}

} // namespace raylab::lab02
