// The host scene's arrays as a kernel on the host sees them.
#include "common/scene/scene.h"

#include <cassert>

namespace raylab {
namespace {

template <class T> Array<T> array_of(const std::vector<T>& items) {
    return {items.data(), int(items.size())};
}

} // namespace

SceneView view(const Scene& scene) {
    assert(scene.spheres.size() <= scene.sphere_groups.size() * spheres_per_group);
    assert(scene.quads.size() <= scene.quad_groups.size() * quads_per_group);
    SceneView v;
    v.camera = scene.camera;
    v.spheres = array_of(scene.spheres);
    v.sphere_groups = array_of(scene.sphere_groups);
    v.quads = array_of(scene.quads);
    v.quad_groups = array_of(scene.quad_groups);
    v.planes = array_of(scene.planes);
    v.triangles = array_of(scene.triangles);
    v.runs = array_of(scene.runs);
    v.corners = array_of(scene.corners);
    v.corner_colours = array_of(scene.corner_colours);
    v.materials = array_of(scene.materials);
    v.lights = array_of(scene.lights);
    v.textures = array_of(scene.textures);
    v.texels = array_of(scene.texels);
    v.environment = {scene.environment_radiance,
                     scene.environment_light,
                     scene.environment_width,
                     scene.environment_height,
                     scene.environment_turn,
                     array_of(scene.environment_map),
                     array_of(scene.environment_row_cdf),
                     array_of(scene.environment_column_cdf)};
    return v;
}

} // namespace raylab
