// The one list of a scene's arrays. Code that copies, counts or points to all of them uses it.
#pragma once

#include "common/scene/scene.h"

namespace raylab {

// Calls visit(items, array) for every std::vector of the scene that kernels read, and the Array of
// the view that points to it.
template <class Visit>
void for_each_array(const Scene& scene, SceneView& view, const Visit& visit) {
    visit(scene.spheres, view.spheres);
    visit(scene.sphere_groups, view.sphere_groups);
    visit(scene.quads, view.quads);
    visit(scene.quad_groups, view.quad_groups);
    visit(scene.planes, view.planes);
    visit(scene.triangles, view.triangles);
    visit(scene.runs, view.runs);
    visit(scene.corners, view.corners);
    visit(scene.corner_colours, view.corner_colours);
    visit(scene.materials, view.materials);
    visit(scene.lights, view.lights);
    visit(scene.textures, view.textures);
    visit(scene.texels, view.texels);
    visit(scene.environment_map, view.environment.map);
    visit(scene.environment_row_cdf, view.environment.row_cdf);
    visit(scene.environment_column_cdf, view.environment.column_cdf);
}

// What the scene's arrays take, in bytes.
std::size_t scene_bytes(const Scene& scene);

} // namespace raylab
