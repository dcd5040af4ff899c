#include "grader/bench/rays/ray_mesh.h"

#include "common/cli/files.h"
#include "common/load/procedural/procedural.h"
#include "common/load/read_file.h"
#include "common/load/scene_builder.h"
#include "common/load/scene_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::bench {

namespace {

constexpr double half_angle_tan = 0.24 / 0.7;

// Gives each triangle its place for an id.
void number_faces(RayMesh& mesh) {
    if (mesh.triangles.empty())
        throw SceneError(mesh.name + " has no triangles with an area: there is nothing to trace");
    int place = 0;
    for (Triangle& triangle : mesh.triangles) triangle.tags.id = place++;
}

void add_triangle(RayMesh& mesh, Vec3 a, Vec3 b, Vec3 c, int id) {
    Triangle triangle{{a, b, c}, {}, -1, {id, 0, -1}};
    if (set_normal(triangle)) mesh.triangles.push_back(triangle);
}

RayMesh from_mesh(const std::string& name, const Mesh& source) {
    RayMesh mesh;
    mesh.name = name;
    mesh.triangles.reserve(source.triangles.size());
    for (const MeshTriangle& t : source.triangles)
        add_triangle(mesh, source.positions[t.position[0]], source.positions[t.position[1]],
                     source.positions[t.position[2]], 0);
    number_faces(mesh);
    return mesh;
}

} // namespace

Bounds bounds_of(std::span<const Triangle> triangles) {
    Bounds bounds;
    for (const Triangle& triangle : triangles)
        for (const Vec3& v : triangle.v) bounds.include(v);
    return bounds;
}

Camera pinhole(DVec3 position, DVec3 look_at) {
    const DVec3 view = look_at - position;
    const DVec3 forward = view / std::sqrt(dot(view, view));
    const bool upright = std::fabs(forward.y) < 0.999; // else -z is up in the picture
    const DVec3 side = cross(forward, upright ? DVec3(0, 1, 0) : DVec3(0, 0, -1));
    const DVec3 right = side / std::sqrt(dot(side, side));
    Camera camera{};
    camera.position = position;
    camera.forward = forward;
    camera.right = right;
    camera.up = cross(right, forward);
    camera.half_width = camera.half_height = half_angle_tan;
    return camera;
}

Camera view_from_front(const Bounds& bounds) {
    const DVec3 low(bounds.low), high(bounds.high), middle = (low + high) / 2.0;
    const double half = std::max({high.x - low.x, high.y - low.y, (high.z - low.z) / 8}) / 2;
    return pinhole(DVec3(middle.x, middle.y, high.z + half / half_angle_tan), middle);
}

// Seen from a distance D from the middle, a point p is in the picture if both |p . right| and |p .
// up| are at most tan (D + p . forward), with p relative to the middle.
Camera view_from_above(std::span<const Triangle> triangles) {
    const Bounds bounds = bounds_of(triangles);
    const DVec3 middle = (DVec3(bounds.low) + DVec3(bounds.high)) / 2.0;
    const DVec3 direction = DVec3(0.6, 0.8, 1.2);
    Camera camera = pinhole(middle + direction, middle);
    double distance = 0;
    for (const Triangle& triangle : triangles)
        for (const Vec3& v : triangle.v) {
            const DVec3 p = DVec3(v) - middle;
            const double aside = std::max(std::fabs(dot(p, DVec3(camera.right))),
                                          std::fabs(dot(p, DVec3(camera.up))));
            distance = std::max(distance, aside / half_angle_tan - dot(p, DVec3(camera.forward)));
        }
    camera.position = middle - distance * DVec3(camera.forward);
    return camera;
}

RayMesh polygons_of(const Scene& scene) {
    RayMesh mesh;
    mesh.name = scene.name;
    for (const auto& [n, what] :
         {std::pair(scene.spheres.size(), "spheres"), std::pair(scene.planes.size(), "planes")})
        if (n > 0)
            mesh.left_out += fmt::format("{}{} {}", mesh.left_out.empty() ? "" : ", ", n, what);
    for (const Quad& q : scene.quads) {
        add_triangle(mesh, q.v[0], q.v[1], q.v[2], q.tags.id);
        add_triangle(mesh, q.v[0], q.v[2], q.v[3], q.tags.id);
    }
    mesh.triangles.insert(mesh.triangles.end(), scene.triangles.begin(), scene.triangles.end());
    std::stable_sort(mesh.triangles.begin(), mesh.triangles.end(),
                     [](const Triangle& a, const Triangle& b) { return a.tags.id < b.tags.id; });
    number_faces(mesh);
    mesh.camera = scene.camera;
    mesh.camera.lens_radius = 0;
    return mesh;
}

RayMesh load_ray_mesh(const std::filesystem::path& file) {
    const auto read = [&](const std::string& name) {
        return read_file_or_throw(file.parent_path() / name);
    };
    const Mesh source = parse_mesh(read_file_or_throw(file), file.string(), read, MeshLook::none);
    RayMesh mesh = from_mesh(file.stem().string(), source);
    mesh.camera = view_from_front(bounds_of(mesh.triangles));
    return mesh;
}

RayMesh procedural_ray_mesh(const std::string& kind, int triangles, std::uint32_t seed) {
    RayMesh mesh = from_mesh(kind + ":" + std::to_string(triangles),
                             find_procedural_mesh(kind)->make(triangles, seed));
    mesh.camera = kind == "stadium" ? pinhole(DVec3(12, 5, 4), DVec3(5, 2, -3))
                                    : view_from_above(mesh.triangles);
    return mesh;
}

} // namespace raylab::bench
