// The host scene's arrays as a kernel on the host sees them.
#include "common/scene/scene_arrays.h"

#include <cassert>

namespace raylab {

SceneView view(const Scene& scene) {
    assert(scene.spheres.size() <= scene.sphere_groups.size() * spheres_per_group);
    assert(scene.quads.size() <= scene.quad_groups.size() * quads_per_group);
    SceneView v;
    v.camera = scene.camera;
    v.environment.radiance = scene.environment_radiance;
    v.environment.light = scene.environment_light;
    v.environment.width = scene.environment_width;
    v.environment.height = scene.environment_height;
    v.environment.turn = scene.environment_turn;
    for_each_array(scene, v, [](const auto& items, auto& array) {
        array = {items.data(), static_cast<int>(items.size())};
    });
    return v;
}

std::size_t scene_bytes(const Scene& scene) {
    std::size_t bytes = 0;
    SceneView v;
    for_each_array(
        scene, v, [&bytes](const auto& items, auto&) { bytes += items.size() * sizeof(items[0]); });
    return bytes;
}

} // namespace raylab
