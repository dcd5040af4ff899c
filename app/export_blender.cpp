#include "app/export_blender.h"

#include "app/labs.h"
#include "app/python_parts.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace raylab::app {

namespace {

using nlohmann::json;

[[noreturn]] void refuse(const std::string& what) {
    throw UsageError("cannot be written for Blender Cycles: " + what);
}

json triple(Vec3 v) { return {v.x, v.y, v.z}; }

// Throws UsageError with one sentence for a scene that has something the export does not know.
void check_known(const Scene& scene) {
    if (scene.render.integrator != Integrator::path)
        refuse("it follows whole paths; use --integrator path");
    if (scene.render.max_depth < 2) refuse("with max_depth 1 nothing scatters");
    if (scene.camera.lens_radius > 0) refuse("the export has no lens, only the pinhole camera");
    if (!scene.planes.empty()) refuse("it has no endless planes; use a large quad");
    if (scene.environment_light >= 0) refuse("the export has no environment light");
    for (const Light& light : scene.lights)
        if (light.kind == LightKind::point) refuse("it has no point lights, only small spheres");
    for (const Triangle& triangle : scene.triangles)
        if (triangle.corners >= 0) refuse("the export has no meshes with shading normals");
}

json material_json(const Scene& scene, int index) {
    const Material& m = scene.materials[index];
    const std::string& name = scene.material_names[index];
    if (m.texture >= 0) refuse(fmt::format("the material '{}' has a texture", name));
    if (m.kind == MaterialKind::glass && m.fresnel != FresnelModel::exact)
        refuse(fmt::format("the material '{}' uses Schlick's approximation", name));
    if (m.kind != MaterialKind::diffuse && is_emissive(m))
        refuse(fmt::format("the material '{}' glows and is not diffuse", name));
    const std::map<MaterialKind, const char*> kinds = {{MaterialKind::diffuse, "diffuse"},
                                                       {MaterialKind::mirror, "mirror"},
                                                       {MaterialKind::glass, "glass"}};
    const auto kind = kinds.find(m.kind);
    if (kind == kinds.end())
        refuse(fmt::format("the material '{}' is neither diffuse, mirror nor glass", name));
    return {{"kind", kind->second},
            {"reflectance", triple(m.reflectance)},
            {"emission", triple(m.emission)},
            {"ior", m.ior}};
}

// Flat faces of one material; a quad is cut from its corner 0 to its corner 2.
struct Faces {
    json positions = json::array(), faces = json::array();

    void add(const Vec3* v, int corners) {
        const std::size_t first = positions.size();
        for (int i = 0; i < corners; ++i) positions.push_back(triple(v[i]));
        for (int i = 2; i < corners; ++i) faces.push_back({first, first + i - 1, first + i});
    }
};

// The near and the far clip distance of Blender's camera: it draws nothing nearer than the first
// and nothing farther away than the second.
json clip_distances(const Scene& scene) {
    float reach = 0;
    const auto reach_to = [&](Vec3 p, float r) {
        reach = std::max(reach, length(p - scene.camera.position) + r);
    };
    for (const Sphere& sphere : scene.spheres) reach_to(sphere.center, sphere.radius);
    for (const Quad& quad : scene.quads)
        for (const Vec3& v : quad.v) reach_to(v, 0);
    for (const Triangle& triangle : scene.triangles)
        for (const Vec3& v : triangle.v) reach_to(v, 0);
    return {1e-4f * reach, 1e2f * reach};
}

json scene_json(const Scene& scene) {
    std::set<int> used;
    std::map<int, Faces> meshes;
    for (const Quad& quad : scene.quads) meshes[quad.tags.material].add(quad.v, 4);
    for (const Triangle& triangle : scene.triangles)
        meshes[triangle.tags.material].add(triangle.v, 3);
    json result = {
        {"meshes", json::array()}, {"spheres", json::array()}, {"materials", json::object()}};
    for (const auto& [material, mesh] : meshes) {
        used.insert(material);
        result["meshes"].push_back({{"material", scene.material_names[material]},
                                    {"positions", mesh.positions},
                                    {"faces", mesh.faces}});
    }
    for (const Sphere& sphere : scene.spheres) {
        used.insert(sphere.tags.material);
        result["spheres"].push_back({{"center", triple(sphere.center)},
                                     {"radius", sphere.radius},
                                     {"material", scene.material_names[sphere.tags.material]}});
    }
    for (const int material : used)
        result["materials"][scene.material_names[material]] = material_json(scene, material);
    const Camera& camera = scene.camera;
    result["camera"] = {{"position", triple(camera.position)},
                        {"right", triple(camera.right)},
                        {"up", triple(camera.up)},
                        {"forward", triple(camera.forward)},
                        {"vfov", 2 * std::atan(double(camera.half_height))},
                        {"clip", clip_distances(scene)}};
    result["film"] = {camera.width, camera.height};
    result["bounces"] = scene.render.max_depth - 2;
    result["spp"] = scene.render.spp;
    result["seed"] = scene.render.seed;
    return result;
}

} // namespace

std::vector<ExportedFile> blender_files(const Scene& scene) {
    check_known(scene);
    // Python reads some JSON escapes in another way. The names have none of these: all characters
    // beyond ASCII are escaped here.
    const std::string data = scene_json(scene).dump(-1, ' ', true);
    const std::string quoted = json(data).dump();
    return {{"scene.py", fmt::format("# Written by raylab export; the scene's hash is {}.\n"
                                     "# blender -b --python scene.py -- --spp 64 -o image.exr\n"
                                     "import json\n\nSCENE = json.loads({})\n\n{}",
                                     scene.hash, quoted, export_blender_py)}};
}

} // namespace raylab::app
