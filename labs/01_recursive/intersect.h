// closest_hit() finds the first shape that a ray meets; any_hit() asks whether there is any.
#pragma once

#include "common/geometry/quad.h"
#include "common/scene/view.h"
#include "labs/01_recursive/sphere.h"
#include "labs/01_recursive/triangle.h"

namespace raylab::lab01 {

// Calls visit(shape, index, id, t) for every hit in (0, ray.t_max), until visit returns false.
template <class Visit>
void for_each_hit(const SceneView& scene, const Ray& ray, const Visit& visit) {
    const ShearedRay sheared(ray);
    float t;
    for (int i = 0; i < scene.spheres.size; ++i)
        if (hit_sphere(scene.spheres[i], ray, t) &&
            !visit(Shape::sphere, i, scene.spheres[i].tags.id, t))
            return;
    for (int i = 0; i < scene.planes.size; ++i)
        if (intersect(scene.planes[i], ray, t) &&
            !visit(Shape::plane, i, scene.planes[i].tags.id, t))
            return;
    for (int i = 0; i < scene.quads.size; ++i)
        if (intersect(scene.quads[i], sheared, t) &&
            !visit(Shape::quad, i, scene.quads[i].tags.id, t))
            return;
    // Triangles lie in runs of neighbours with a box around each run: skip it if the box is missed.
    const SlabRay slab(ray);
    for (int r = 0; r < scene.runs.size; ++r) {
        const TriangleRun& run = scene.runs[r];
        if (!crosses(run.bounds, slab, ray.t_max)) continue;
        for (int i = run.first; i < run.first + run.count; ++i)
            if (hit_triangle(scene.triangles[i], sheared, t) &&
                !visit(Shape::triangle, i, scene.triangles[i].tags.id, t))
                return;
    }
}

// The closest hit. Of two hits at the same t, the one with the lower id counts.
inline Hit closest_hit(const SceneView& scene, const Ray& ray) {
    Hit hit;
    //[ task 1.2
    for_each_hit(scene, ray, [&](Shape shape, int index, int id, float t) {
        if (hit.is_beaten_by(t, id)) hit = {t, id, shape, index};
        return true;
    });
    //| not_implemented("1.2", "closest_hit()");
    //]
    return hit;
}

// Is anything in the ray's way?
inline bool any_hit(const SceneView& scene, const Ray& ray) {
    bool found = false;
    for_each_hit(scene, ray, [&](Shape, int, int, float) {
        found = true;
        return false;
    });
    return found;
}

} // namespace raylab::lab01
