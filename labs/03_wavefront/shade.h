// Stages 3 and 4: at every surface that was hit, the light it gives and the ray that goes on.
//
// The body of lab 02's loop, without the two calls that trace rays: the next ray and the shadow ray
// go into the pool. It is compiled once for all materials, and once for each kind alone (F without
// the other kinds). In those kernels no thread of a warp waits for another thread's BSDF.
// PBR4e 13.2 and 14.1; Laine, Karras and Aila 2013, section 3.
#pragma once

#include "common/task/not_implemented.h"
#include "common/trace/texture.h"
#include "common/transport/direct_light.h"
#include "common/wavefront/generate.h"
#include "common/wavefront/roulette.h"
#include "labs/03_wavefront/wavefront_view.h"

namespace raylab::lab03 {

// Returns whether the slot has a shadow ray to be traced.
template <Features F> HD bool shade_path(const WavefrontView& wave, int slot) {
    // Steps:
    // 1. Read ray, bounce and throughput; find surface, material, reflectance and wo.
    // 2. The throughput times what the surface emits joins the radiance.
    // 3. At the last surface the path ends by depth, without a shadow ray.
    // 4. Ask for a shadow ray. One that is sent goes into the pool by send_shadow_ray(), its light
    //    times the throughput.
    // 5. Choose a direction. Without a valid one the path is absorbed; roulette may end it, too.
    // 6. Else write what the next bounce reads: ray, throughput, density, bounce.
    // 7. Return whether there is a shadow ray.
    //[ task 3.1
    const SceneView& scene = wave.scene;
    const RenderSettings& settings = wave.settings;
    const PoolView& pool = wave.pool;
    const Ray ray = ray_of(pool, slot);
    const int bounce = pool.bounce[slot];
    Vec3 throughput = pool.throughput[slot];

    const SurfacePoint surface = surface_at<F>(scene, ray, pool.hit[slot]);
    const Material& material = scene.materials[surface.material];
    const Vec3 reflectance = reflectance_at<F>(scene, material, surface);
    const Vec3 wo = -ray.d;

    // What it emits towards us.
    pool.radiance[slot] += throughput * emitted_light<F>(scene, settings.direct_light, ray,
                                                         pool.bsdf_pdf[slot], surface);
    if (bounce + 1 == settings.max_depth) {
        end_path(pool, slot, PathEnd::depth);
        return false;
    }

    // What it would scatter of a light source, if nothing is in the way.
    const BounceNumbers u = sampler_of(wave, slot).get_bounce(bounce);
    const ShadowRay shadow_ray =
        shadow_ray_to_any<F>(scene, settings.direct_light, surface, reflectance, wo, u);
    if (shadow_ray.sent) send_shadow_ray(pool, slot, shadow_ray.ray, throughput * shadow_ray.light);

    // A new direction, and the share of light that comes back from it.
    const BsdfSample scattered =
        sample_bsdf<F>(surface, material, reflectance, wo, u.lobe, u.direction);
    throughput *= scattered.weight;
    if (!scattered.valid) {
        end_path(pool, slot, PathEnd::absorbed);
    } else if (settings.roulette && !survives_roulette(throughput, bounce, u.roulette)) {
        end_path(pool, slot, PathEnd::roulette);
    } else {
        const Ray next = spawn_ray(surface, scattered.wi);
        pool.origin[slot] = next.o;
        pool.direction[slot] = next.d;
        pool.throughput[slot] = throughput;
        pool.bsdf_pdf[slot] = scattered.specular ? delta_pdf : scattered.pdf;
        pool.bounce[slot] = bounce + 1;
    }
    return shadow_ray.sent;
    //| not_implemented("3.1", "shade_path()");
    //| end_path(wave.pool, slot, PathEnd::absorbed);
    //| return false;
    //]
}

} // namespace raylab::lab03
