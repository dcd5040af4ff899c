// The rendering equation, solved by calling itself. Kajiya, The Rendering Equation, 1986.
//
//     L(p, wo) = Le(p, wo) + integral of f(p, wo, wi) L(p', -wi) |cos(wi)| dwi
//
// The integral is estimated with one direction drawn with density pdf:
//     L ~ Le + f |cos| / pdf * L(p', -wi),
// and the L on the right is this function again, one surface further on.
#include "labs/01_recursive/tracer.h"

#include "common/trace/texture.h"
#include "labs/01_recursive/direct_light.h"
#include "labs/01_recursive/intersect.h"
#include "labs/01_recursive/scatter.h"

namespace raylab::lab01 {

namespace {

// Russian roulette: from the second surface on, the path goes on with probability q, and its
// radiance is divided by q. q is 2.5 times the largest channel of the throughput. The throughput is
// the product of all weights so far; a call cannot know it, so it is an argument.
float survival_probability(Vec3 throughput, int bounce) {
    if (bounce < 1) return 1;
    return std::min(1.0f, 2.5f * max_component(throughput));
}

} // namespace

Vec3 trace_path(const Path& path, const Ray& ray, int bounce, float bsdf_pdf, Vec3 throughput) {
    //[ task 1.5
    const SceneView& scene = path.scene;
    const RenderSettings& settings = path.settings;

    const Hit hit = closest_hit(scene, ray);
    record_hit(path.record, hit.id);
    if (!hit.found()) {
        path.record.end = PathEnd::escaped;
        return escaped_light<feature::all>(scene, settings.direct_light, ray, bsdf_pdf);
    }
    const SurfacePoint surface = surface_at<feature::all>(scene, ray, hit);
    const Material& material = scene.materials[surface.material];
    const Vec3 reflectance = reflectance_at<feature::all>(scene, material, surface);
    const Vec3 wo = -ray.d;

    // Le, then the light sources directly.
    Vec3 radiance =
        emitted_light<feature::all>(scene, settings.direct_light, ray, bsdf_pdf, surface);
    path.record.end = PathEnd::depth;
    if (bounce + 1 == settings.max_depth) return radiance;
    radiance += direct_light(path, surface, reflectance, wo, bounce);

    // One direction for the rest of the integral.
    const Vec2 u_lobe = path.sampler.get_2d(bounce_dimension(bounce, dimension::lobe_roulette));
    const Vec2 u_direction = path.sampler.get_2d(bounce_dimension(bounce, dimension::direction));
    const BsdfSample scattered = scatter(surface, material, reflectance, wo, u_lobe.x, u_direction);
    path.record.end = PathEnd::absorbed;
    if (!scattered.valid) return radiance;

    throughput *= scattered.weight;
    Vec3 weight = scattered.weight;
    if (settings.roulette) {
        const float q = survival_probability(throughput, bounce);
        path.record.end = PathEnd::roulette;
        if (u_lobe.y >= q) return radiance;
        throughput /= q;
        weight /= q;
    }
    const float pdf = scattered.specular ? delta_pdf : scattered.pdf;
    return radiance +
           weight * trace_path(path, spawn_ray(surface, scattered.wi), bounce + 1, pdf, throughput);
    //| not_implemented("1.5", "trace_path()");
    //| record_hit(path.record, -1);
    //| return Vec3(0);
    //]
}

} // namespace raylab::lab01
