// What a ray meets in a scene. intersect() finds the closest shape; occluded() asks whether there
// is any shape at all.
#pragma once

#include "common/geometry/plane.h"
#include "common/geometry/quad.h"
#include "common/geometry/quad_group.h"
#include "common/geometry/sphere.h"
#include "common/geometry/sphere_group.h"
#include "common/geometry/triangle.h"
#include "common/math/features.h"
#include "common/scene/view.h"

namespace raylab {

// Calls visit(shape, index, id, t) for every sphere of the group that the ray meets, until visit
// returns false. Returns false in that case. reach(): the largest t that is still of interest.
template <class Visit, class Reach>
HD_HOT bool for_each_hit_in(const SphereGroup& group, const Array<Sphere>& spheres, const Ray& ray,
                            const Visit& visit, const Reach& reach) {
    float t;
    const std::uint32_t maybe =
        group.count > few_spheres ? glance(group, ray, reach()) : (1u << group.count) - 1;
    for (std::uint32_t left = maybe; left != 0; left &= left - 1) {
        const int i = group.first + lowest_bit(left);
        const Sphere& sphere = spheres[i];
        if (intersect(sphere, ray, t) && !visit(Shape::sphere, i, sphere.tags.id, t)) return false;
    }
    return true;
}

// The same for a group of quads.
template <class Visit, class Reach>
HD_HOT bool for_each_hit_in(const QuadGroup& group, const Array<Quad>& quads, const Ray& ray,
                            const Visit& visit, const Reach& reach) {
    float t;
    const QuadGlance seen = glance(group, ray, reach());
    for (std::uint32_t left = seen.maybe; left != 0; left &= left - 1) {
        const int lane = lowest_bit(left), i = group.first + lane;
        if (seen.begin[lane] > reach()) continue; // false for NaN: such a quad is tested
        const Quad& quad = quads[i];
        const bool met = seen.sure >> lane & 1 ? intersect_inside(quad, ray, t)
                                               : intersect(quad, ShearedRay(ray), t);
        if (met && !visit(Shape::quad, i, quad.tags.id, t)) return false;
    }
    return true;
}

// Calls visit(shape, index, id, t) for every shape the ray meets in (0, ray.t_max), until visit
// returns false. Shapes that the ray meets only beyond reach() may be skipped.
template <Features F, class Visit, class Reach>
HD void for_each_hit(const SceneView& scene, const Ray& ray, const Visit& visit,
                     const Reach& reach) {
    float t;
    if constexpr (F & feature::sphere) {
        for (int g = 0; g < scene.sphere_groups.size; ++g)
            if (!for_each_hit_in(scene.sphere_groups[g], scene.spheres, ray, visit, reach)) return;
    }
    if constexpr (F & feature::plane) {
        for (int i = 0; i < scene.planes.size; ++i) {
            const Plane& plane = scene.planes[i];
            if (intersect(plane, ray, t) && !visit(Shape::plane, i, plane.tags.id, t)) return;
        }
    }
    if constexpr (F & feature::quad) {
        for (int g = 0; g < scene.quad_groups.size; ++g)
            if (!for_each_hit_in(scene.quad_groups[g], scene.quads, ray, visit, reach)) return;
    }
    if constexpr (F & feature::triangle) {
        const ShearedRay sheared(ray);
        const SlabRay slab(ray);
        for (int r = 0; r < scene.runs.size; ++r) {
            const TriangleRun& run = scene.runs[r];
            if (!crosses(run.bounds, slab, reach())) continue;
            for (int i = run.first; i < run.first + run.count; ++i) {
                const Triangle& triangle = scene.triangles[i];
                if (intersect(triangle, sheared, t) &&
                    !visit(Shape::triangle, i, triangle.tags.id, t))
                    return;
            }
        }
    }
}

// The closest hit in (0, ray.t_max), or `hit` if nothing is closer. Of two hits at the same t, the
// one with the lower id counts, so it does not matter which shapes were tested first.
// F: the features of the scene. The kernel has no code for shapes that are not in F.
template <Features F> HD Hit intersect(const SceneView& scene, const Ray& ray, Hit hit = {}) {
    for_each_hit<F>(
        scene, ray,
        [&](Shape shape, int index, int id, float t) {
            if (hit.is_beaten_by(t, id)) hit = {t, id, shape, index};
            return true;
        },
        [&] { return glm::min(hit.t, ray.t_max); });
    return hit;
}

// Does the ray meet any shape in (0, ray.t_max)?
template <Features F> HD bool occluded(const SceneView& scene, const Ray& ray) {
    bool found = false;
    for_each_hit<F>(
        scene, ray,
        [&](Shape, int, int, float) {
            found = true;
            return false;
        },
        [&] { return ray.t_max; });
    return found;
}

} // namespace raylab
