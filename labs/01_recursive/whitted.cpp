// Whitted's recursive ray tracer. Whitted, An Improved Illumination Model for Shaded Display, 1980;
// the lecture's "Recursive Ray-tracing".
//
// A surface sends shadow rays to every light. A mirror calls the tracer again for the light that it
// reflects, glass calls it twice. So the rays form a tree, which the calls visit depth first.
#include "labs/01_recursive/tracer.h"

#include "common/trace/texture.h"
#include "labs/01_recursive/direct_light.h"
#include "labs/01_recursive/intersect.h"
#include "labs/01_recursive/scatter.h"

namespace raylab::lab01 {

// node numbers the ray tree: root 1, reflection 2n, refraction 2n + 1. It stands in for the bounce
// in the random numbers' dimensions, the same in every lab.
Vec3 trace_whitted(const Path& path, const Ray& ray, int depth, std::uint32_t node) {
    //[ task 1.4
    const SceneView& scene = path.scene;
    path.record.end = PathEnd::absorbed;

    const Hit hit = closest_hit(scene, ray);
    record_hit(path.record, hit.id);
    if (!hit.found()) return escaped_light<feature::all>(scene, DirectLight::light, ray, delta_pdf);
    const SurfacePoint surface = surface_at<feature::all>(scene, ray, hit);
    const Material& material = scene.materials[surface.material];
    const Vec3 reflectance = reflectance_at<feature::all>(scene, material, surface);
    const Vec3 wo = -ray.d;

    Vec3 radiance = material.emission;
    if (depth + 1 == path.settings.max_depth) return radiance;
    if (!is_specular<feature::all>(material)) {
        for (int light = 0; light < scene.lights.size; ++light)
            radiance += light_from(path, DirectLight::light, light, 1, surface, reflectance, wo,
                                   path.sampler.get_2d(shadow_ray_dimension(node, light)));
        return radiance;
    }

    const SpecularSplit split = split_light(surface, material, reflectance, wo);
    const Ray reflected = spawn_ray(surface, split.reflected);
    radiance += split.reflected_weight * trace_whitted(path, reflected, depth + 1, 2 * node);
    if (split.refracts) {
        const Ray refracted = spawn_ray(surface, split.refracted);
        radiance +=
            split.refracted_weight * trace_whitted(path, refracted, depth + 1, 2 * node + 1);
    }
    return radiance;
    //| not_implemented("1.4", "trace_whitted()");
    //| record_hit(path.record, -1);
    //| return Vec3(0);
    //]
}

} // namespace raylab::lab01
