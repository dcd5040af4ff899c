// The material of what a ray has hit, without the rest of the surface point.
#pragma once

#include "common/geometry/ray.h"
#include "common/math/features.h"
#include "common/scene/view.h"

namespace raylab {

template <Features F> HD const Material& material_at(const SceneView& scene, const Hit& hit) {
    int material = 0;
    if constexpr (F & feature::sphere)
        if (hit.shape == Shape::sphere) material = scene.spheres[hit.index].tags.material;
    if constexpr (F & feature::quad)
        if (hit.shape == Shape::quad) material = scene.quads[hit.index].tags.material;
    if constexpr (F & feature::plane)
        if (hit.shape == Shape::plane) material = scene.planes[hit.index].tags.material;
    if constexpr (F & feature::triangle)
        if (hit.shape == Shape::triangle) material = scene.triangles[hit.index].tags.material;
    return scene.materials[material];
}

} // namespace raylab
