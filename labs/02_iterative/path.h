// A path as a loop. PBR4e 13.2 and 14.1; Kajiya 1986.
//
// The rendering equation, unrolled along one random path p0 p1 p2 ...:
//     L = Le(p1) + T1 Le(p2) + T1 T2 Le(p3) + ...,   Tk = f(pk) |cos| / pdf.
// The recursive tracer multiplies by Tk when a call returns. A loop has no calls that return, so it
// carries the product T1 T2 ... Tk forward: the *throughput*. It starts at one. The light that a
// surface adds is multiplied by it.
#pragma once

#include "common/task/not_implemented.h"
#include "common/trace/texture.h"
#include "common/transport/direct_light.h"

namespace raylab::lab02 {

// Russian roulette: a path survives with probability q, and survivors count 1/q, so the mean stays.
//     E[survives ? T/q : 0] = q (T/q) = T
// This holds for any q. Dim paths should end: from the second surface on, q = 2.5 times the largest
// channel of the throughput, so a path with 40 % of its light or more is never ended.
// Returns false if the path ends. u: random, uniform in [0, 1).
HD bool survives_roulette(Vec3& throughput, int bounce, float u) {
    //[ task 2.5
    if (bounce < 1) return true;
    const float q = glm::min(1.0f, 2.5f * max_component(throughput));
    if (u >= q) return false;
    throughput /= q;
    return true;
    //| not_implemented("2.5", "survives_roulette()");
    //| return true;
    //]
}

// Radiance along `ray`, by one path. record: what became of the path.
template <Features F>
HD Vec3 trace_path(const SceneView& scene, const RenderSettings& settings, const Sampler& sampler,
                   Ray ray, PathRecord& record) {
    //[ task 2.1
    Vec3 radiance(0);           // what the path has collected
    Vec3 throughput(1);         // factor for the light that the path collects from here on
    float bsdf_pdf = delta_pdf; // density of the direction of `ray`
    record = {};

    for (int bounce = 0; bounce < settings.max_depth; ++bounce) {
        // 1. The closest surface, or the sky.
        const Hit hit = intersect<F>(scene, ray);
        record_hit(record, hit.id);
        if (!hit.found()) {
            radiance += throughput * escaped_light<F>(scene, settings.direct_light, ray, bsdf_pdf);
            record.end = PathEnd::escaped;
            break;
        }
        const SurfacePoint surface = surface_at<F>(scene, ray, hit);
        const Material& material = scene.materials[surface.material];
        const Vec3 reflectance = reflectance_at<F>(scene, material, surface);
        const Vec3 wo = -ray.d;

        // 2. What it emits towards us, and what it scatters of the light sources.
        radiance +=
            throughput * emitted_light<F>(scene, settings.direct_light, ray, bsdf_pdf, surface);
        if (bounce + 1 == settings.max_depth) break;
        const BounceNumbers u = sampler.get_bounce(bounce);
        radiance += throughput * direct_light<F>(scene, settings.direct_light, surface, reflectance,
                                                 wo, u, record);

        // 3. A new direction, and the share of light that comes back from it.
        const BsdfSample scattered =
            sample_bsdf<F>(surface, material, reflectance, wo, u.lobe, u.direction);
        if (!scattered.valid) {
            record.end = PathEnd::absorbed;
            break;
        }
        throughput *= scattered.weight;
        if (settings.roulette && !survives_roulette(throughput, bounce, u.roulette)) {
            record.end = PathEnd::roulette;
            break;
        }

        // 4. Go there.
        ray = spawn_ray(surface, scattered.wi);
        bsdf_pdf = scattered.specular ? delta_pdf : scattered.pdf;
    }
    return radiance;
    //| not_implemented("2.1", "trace_path()");
    //| record_hit(record, -1);
    //| return Vec3(0);
    //]
}

} // namespace raylab::lab02
