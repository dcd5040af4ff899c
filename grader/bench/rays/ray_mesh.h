// What a bench of rays traces: triangles, and a camera that looks at them.
#pragma once

#include "common/camera/camera.h"
#include "common/geometry/shapes.h"
#include "common/load/mesh.h"
#include "common/scene/scene.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace raylab::bench {

struct RayMesh {
    std::string name;
    std::string left_out;            // "2 spheres": of a scene, what is no polygon
    std::vector<Triangle> triangles; // tags.id is the place in this list
    Camera camera{};                 // a pinhole; the film is square, size 0 until it is set
};

Bounds bounds_of(std::span<const Triangle> triangles);

// A pinhole at a place, y up in the picture, the vertical half angle's tangent .24 / .7: the
// Cornell box's.
Camera pinhole(DVec3 position, DVec3 look_at);

// Looks along -z from before the bounding box, whose front just fills the film. So the camera sees
// into a room that is open at the front, as the meshes of other programs' benches stand in one.
Camera view_from_front(const Bounds& bounds);

// Looks from above, from the front and from the right, as close as still shows the whole mesh.
Camera view_from_above(std::span<const Triangle> triangles);

// A scene's triangles, and its quads as two each, seen by its camera. These throw SceneError if
// there is no triangle with an area.
RayMesh polygons_of(const Scene& scene);

// .obj, .gltf or .glb, seen from the front.
RayMesh load_ray_mesh(const std::filesystem::path& file);

// A mesh made by a program (common/load/procedural), seen from above. The stadium is seen from
// close to its flake.
RayMesh procedural_ray_mesh(const std::string& kind, int triangles, std::uint32_t seed);

} // namespace raylab::bench
