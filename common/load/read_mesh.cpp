// A mesh shape: the file's triangles in world space, each with its id, its material and, where a
// corner has a normal or a texture coordinate that matters, its corner data.
#include "common/load/mesh.h"

#include "common/cli/files.h"
#include "common/load/read_file.h"
#include "common/load/scene_builder.h"
#include "common/load/scene_error.h"
#include "common/load/suggest.h"
#include "common/scene/triangle_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace raylab {
namespace {

DVec3 unit_or(DVec3 n, DVec3 otherwise) {
    const double size = std::sqrt(dot(n, n));
    return size > 0 && std::isfinite(size) ? n / size : otherwise;
}

bool is_mesh_name(const std::string& name) {
    const std::string extension = ending_of(name);
    return extension == ".obj" || extension == ".gltf" || extension == ".glb";
}

} // namespace

Mesh parse_mesh(std::string_view bytes, const std::string& name, const ReadNamedFile& read,
                MeshLook look) {
    if (!is_mesh_name(name)) throw SceneError(name + ": expected a mesh file: .obj, .gltf or .glb");
    if (ending_of(name) == ".obj")
        return parse_obj(bytes, name, look == MeshLook::own ? read : ReadNamedFile());
    return parse_gltf(bytes, name, read, look);
}

std::vector<std::string> material_keys(const Mesh& mesh) {
    std::vector<std::string> keys;
    std::map<int, std::string> of_source;
    std::set<std::string> taken;
    for (const MeshMaterial& material : mesh.materials) {
        const auto found = of_source.find(material.source);
        if (material.source >= 0 && found != of_source.end()) {
            keys.push_back(found->second);
            continue;
        }
        const std::string name =
            material.name.empty() ? fmt::format("material {}", taken.size() + 1) : material.name;
        std::string key = name;
        for (int i = 2; !taken.insert(key).second; ++i) key = fmt::format("{} {}", name, i);
        of_source[material.source] = key;
        keys.push_back(key);
    }
    return keys;
}

void SceneBuilder::read_mesh(const Node& shape) {
    const Node file = shape.at("file");
    if (!is_mesh_name(file.string())) file.fail_expected("a mesh file: .obj, .gltf or .glb");
    if (shape.has("material") && shape.has("materials"))
        shape.at("materials")
            .fail("expected material (for the whole mesh) or materials (for some of the file's "
                  "own), found both; remove one");
    const std::string bytes = read_named_file(file);
    const std::filesystem::path path = folder_ / file.string();
    Mesh mesh;
    try {
        const auto read = [&](const std::string& name) {
            std::string part;
            const std::string problem = read_file(path.parent_path() / name, part);
            if (!problem.empty()) throw SceneError(path.string() + ": " + problem);
            hash_.add(part);
            return part;
        };
        mesh = parse_mesh(bytes, path.string(), read,
                          shape.has("material") ? MeshLook::none : MeshLook::own);
    } catch (const SceneError& error) {
        file.fail(error.what());
    }
    for (const std::string& warning : mesh.warnings) scene_.warnings.push_back(warning);
    add_mesh(shape, file, mesh);
}

// For each of the mesh's own materials, the index of the scene's material that takes its place: the
// one that the shape's "materials" names for it, or else the file's own. For a shape without
// "material".
std::vector<int> SceneBuilder::add_mesh_materials(const Node& shape, const Node& file,
                                                  const Mesh& mesh) {
    const std::vector<std::string> keys = material_keys(mesh);
    std::map<std::string, int> instead;
    if (const auto map = shape.find("materials"))
        for (const auto& [key, material] : map->members()) {
            if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
                const std::set<std::string> names(keys.begin(), keys.end());
                const std::vector<std::string> known(names.begin(), names.end());
                material.fail(fmt::format("the mesh file has no material {}{}; it has {}",
                                          quote(key), did_you_mean(key, known),
                                          known.empty() ? "none" : listed(known)));
            }
            instead[key] = material_named(material);
        }
    std::vector<int> indices;
    using Key = std::tuple<int, float, float, float, Wrap, Wrap>;
    std::map<Key, int> textures; // several materials may have the same
    for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
        if (const auto found = instead.find(keys[i]); found != instead.end()) {
            indices.push_back(found->second);
            continue;
        }
        const MeshMaterial& own = mesh.materials[i];
        Material material = own.material;
        if (own.picture >= 0) {
            const Vec3 factor = material.reflectance;
            const auto [texture, is_new] = textures.try_emplace(
                {own.picture, factor.x, factor.y, factor.z, own.wrap_u, own.wrap_v});
            if (is_new)
                texture->second = add_texture(mesh.pictures[std::size_t(own.picture)], file, factor,
                                              own.wrap_u, own.wrap_v);
            material.texture = texture->second;
        }
        indices.push_back(add_material(material, own.name));
    }
    return indices;
}

// Adds the file's point lights if the shape asks for them: a scene may have lights of its own
// instead.
void SceneBuilder::add_mesh_lights(const Node& shape, const Mesh& mesh,
                                   const Transform& transform) {
    const auto wanted = shape.find("lights");
    if (wanted && wanted->boolean() && mesh.lights.empty())
        wanted->fail("the mesh file has no point lights; remove this key");
    if (!wanted && !mesh.lights.empty())
        scene_.warnings.push_back(fmt::format(
            "{}: the file's {} point lights are left out; \"lights\": true takes them, false says "
            "that they are not wanted",
            shape.place(), mesh.lights.size()));
    if (!wanted || !wanted->boolean()) return;
    for (const MeshLight& light : mesh.lights)
        if (!is_black(light.intensity))
            mesh_lights_.push_back(
                {LightKind::point, -1, placed(shape, transform, light.position), light.intensity});
}

void SceneBuilder::add_mesh(const Node& shape, const Node& from, Mesh& mesh) {
    if (scene_.triangles.size() + mesh.triangles.size() > max_triangles)
        from.fail(fmt::format("the scene has more than {} triangles; use fewer or smaller meshes",
                              max_triangles));
    const auto named = shape.find("material");
    const int material = named ? material_named(*named) : -1;
    const std::vector<int> own = named ? std::vector<int>{} : add_mesh_materials(shape, from, mesh);
    const auto smooth_node = shape.find("smooth");
    const bool flat = smooth_node && !smooth_node->boolean();
    if (smooth_node && !flat &&
        std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                    [](const MeshTriangle& t) { return t.normal[0] < 0; }))
        compute_smooth_normals(mesh);

    const Transform transform = read_transform(shape);
    add_mesh_lights(shape, mesh, transform);
    const glm::dmat3 normal_matrix = glm::transpose(glm::inverse(transform.linear));
    const int first = int(scene_.triangles.size());
    int dropped = 0;
    for (const MeshTriangle& source : mesh.triangles) {
        if (!named && source.material < 0)
            shape.fail("expected a key \"material\", since the mesh file gives none for all its "
                       "triangles");
        Triangle triangle{{}, {}, -1, {next_id_, named ? material : own[source.material], -1}};
        // corner[i]: which corner of the file becomes corner i. A mirrored mesh swaps two of them.
        const int corner[3] = {0, transform.mirrors() ? 2 : 1, transform.mirrors() ? 1 : 2};
        for (int i = 0; i < 3; ++i)
            triangle.v[i] = transform.point(mesh.positions[source.position[corner[i]]]);
        if (!set_normal(triangle)) {
            ++dropped;
            continue;
        }
        const bool textured = scene_.materials[triangle.tags.material].texture >= 0;
        if (textured && source.uv[0] < 0)
            (named ? *named : from)
                .fail("the material has a texture, but the mesh has no texture "
                      "coordinates; use a material without, or another mesh");
        const bool smooth = !flat && source.normal[0] >= 0;
        const bool coloured = !named && source.colour[0] >= 0;
        if (textured || smooth || coloured) {
            TriangleCorners corners{{triangle.normal, triangle.normal, triangle.normal}, {}};
            if (coloured) {
                corners.colours = int(scene_.corner_colours.size());
                CornerColours& colours = scene_.corner_colours.emplace_back();
                for (int i = 0; i < 3; ++i)
                    colours.factor[i] = mesh.colours[source.colour[corner[i]]];
            }
            for (int i = 0; i < 3; ++i) {
                if (smooth)
                    corners.normal[i] =
                        unit_or(normal_matrix * mesh.normals[source.normal[corner[i]]],
                                DVec3(triangle.normal));
                if (textured) corners.uv[i] = mesh.uvs[source.uv[corner[i]]];
            }
            triangle.corners = int(scene_.corners.size());
            scene_.corners.push_back(corners);
        }
        ++next_id_;
        scene_.triangles.push_back(triangle);
    }
    if (dropped > 0)
        scene_.warnings.push_back(
            fmt::format("{}: {} of {} triangles have no area or are not finite and are left out",
                        from.place(), dropped, mesh.triangles.size()));
    cut_into_runs(scene_.triangles, first, scene_.runs);
}

} // namespace raylab
