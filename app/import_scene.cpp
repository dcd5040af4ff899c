#include "app/import_scene.h"

#include "app/labs.h"
#include "common/material/bsdf.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

namespace raylab::app {
namespace {

std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string array(DVec3 v) {
    return fmt::format("[{}, {}, {}]", float(v.x), float(v.y), float(v.z));
}

struct Bounds {
    DVec3 low = DVec3(std::numeric_limits<double>::infinity()), high = -low;
};

Bounds bounds_of(const Mesh& mesh) {
    Bounds bounds;
    for (const MeshTriangle& triangle : mesh.triangles)
        for (const int i : triangle.position) {
            const DVec3 p = mesh.positions[std::size_t(i)];
            if (!std::isfinite(p.x + p.y + p.z)) continue;
            bounds.low = glm::min(bounds.low, p);
            bounds.high = glm::max(bounds.high, p);
        }
    if (!(bounds.low.x <= bounds.high.x)) throw UsageError("the mesh has no finite triangle");
    return bounds;
}

// The material as the text of a scene file. Empty if a scene file cannot describe it: a material
// with a picture, or glass that glows.
std::string written(const MeshMaterial& mesh_material) {
    const Material& m = mesh_material.material;
    if (mesh_material.picture >= 0 || (is_clear(m) && is_emissive(m))) return "";
    const std::string tint =
        m.reflectance == Vec3(1) ? "" : ", \"reflectance\": " + array(DVec3(m.reflectance));
    const std::string reflectance = ", \"reflectance\": " + array(DVec3(m.reflectance));
    const std::string microfacets =
        m.microfacets == Microfacets::beckmann ? ", \"microfacets\": \"beckmann\"" : "";
    const std::string fresnel =
        m.fresnel == FresnelModel::schlick ? ", \"fresnel\": \"schlick\"" : "";
    std::string text;
    switch (m.kind) {
    case MaterialKind::diffuse:
        text = "\"kind\": \"diffuse\"" + reflectance;
        break;
    case MaterialKind::mirror:
        text = "\"kind\": \"mirror\"" + reflectance;
        break;
    case MaterialKind::glass:
        text = fmt::format("\"kind\": \"glass\", \"ior\": {}", m.ior) + tint + fresnel;
        break;
    case MaterialKind::phong:
        text = fmt::format("\"kind\": \"phong\"{}, \"specular\": {}, \"exponent\": {}", reflectance,
                           array(DVec3(m.specular)), m.exponent);
        break;
    case MaterialKind::conductor:
        text = fmt::format("\"kind\": \"conductor\", \"eta\": {}, \"k\": {}, \"alpha\": {}",
                           array(DVec3(m.eta)), array(DVec3(m.k)), m.alpha) +
               tint + microfacets + fresnel;
        break;
    case MaterialKind::rough_dielectric:
        text = fmt::format("\"kind\": \"rough_dielectric\", \"ior\": {}, \"alpha\": {}", m.ior,
                           m.alpha) +
               tint + microfacets;
        break;
    }
    if (is_emissive(m)) text += ", \"emission\": " + array(DVec3(m.emission));
    return "{" + text + "}";
}

class Importer {
  public:
    Importer(const Mesh& mesh, const std::string& file) : mesh_(mesh), file_(file) {}

    ImportedScene scene(const std::string& title) {
        const Bounds bounds = bounds_of(mesh_);
        const std::string camera = write_camera(bounds);
        const std::string materials = write_materials();
        const std::string lights = write_lights();
        const std::string reason = fmt::format(
            "Imported from {}. Lengths are the file's, y is up. Its triangles and pictures are "
            "read "
            "from the file each time; a material below takes the place of the file's own of the "
            "name that the mesh gives.",
            file_);
        std::string text = "{\n    \"version\": 1,\n";
        text +=
            fmt::format("    \"title\": {},\n    \"reason\": {},\n", quoted(title), quoted(reason));
        text += camera;
        text += "    \"render\": {\"integrator\": \"path\", \"max_depth\": 8, \"spp\": 64, "
                "\"seed\": 1},\n";
        text += fmt::format("    \"materials\": {{{}}},\n", materials);
        text += fmt::format("    \"shapes\": [\n        {{\"kind\": \"mesh\", \"file\": {}{}{}}}\n"
                            "    ],\n",
                            quoted(file_), shape_materials_,
                            mesh_.lights.empty() ? "" : ", \"lights\": false");
        text += fmt::format("    \"lights\": [{}]\n}}\n", lights);
        for (const std::string& warning : mesh_.warnings) notes_.push_back(warning);
        return {text, notes_};
    }

  private:
    std::string write_camera(const Bounds& bounds) {
        const DVec3 center = 0.5 * bounds.low + 0.5 * bounds.high;
        const DVec3 diagonal = bounds.high - bounds.low;
        const double size = std::max(std::sqrt(dot(diagonal, diagonal)), 1e-30);
        constexpr int height = 240;
        double aspect = 4.0 / 3;
        std::string camera;
        if (mesh_.cameras.empty()) {
            // The camera looks from the front, glTF's +z, a little from the right and from above.
            // The sphere around the bounding box touches the frame's edges.
            constexpr double vfov = 40;
            const DVec3 from = glm::normalize(DVec3(0.5, 0.4, 1));
            const double distance = size / 2 / std::sin(vfov / 2 * std::numbers::pi / 180);
            camera = camera_line(center + distance * from, center, DVec3(0, 1, 0), vfov);
            notes_.push_back(
                "it has no camera: this one stands before the whole, in front and above");
        } else {
            const MeshCamera& own = mesh_.cameras.front();
            const DVec3 forward = glm::normalize(own.forward);
            // look_at is a point in front of the camera, as far away as the middle of the scene.
            const double depth = dot(center - own.position, forward);
            camera = camera_line(own.position, own.position + (depth > 0 ? depth : size) * forward,
                                 glm::normalize(own.up), own.vfov_deg);
            if (own.aspect > 0) aspect = std::clamp(own.aspect, 0.1, 10.0);
            for (std::size_t i = 1; i < mesh_.cameras.size(); ++i)
                notes_.push_back(fmt::format(
                    "of its {} cameras the first is taken; another is {}: {}", mesh_.cameras.size(),
                    quoted(mesh_.cameras[i].name), written_camera(mesh_.cameras[i])));
        }
        return camera + fmt::format("    \"film\": {{\"width\": {}, \"height\": {}}},\n",
                                    std::max(1, int(std::lround(aspect * height))), height);
    }

    static std::string written_camera(const MeshCamera& camera) {
        return fmt::format("position {}, look_at {}, up {}, vfov_deg {}", array(camera.position),
                           array(camera.position + camera.forward), array(camera.up),
                           float(camera.vfov_deg));
    }

    static std::string camera_line(DVec3 position, DVec3 look_at, DVec3 up, double vfov_deg) {
        return fmt::format("    \"camera\": {{\"position\": {}, \"look_at\": {}, \"up\": {}, "
                           "\"vfov_deg\": {}}},\n",
                           array(position), array(look_at), array(up), float(vfov_deg));
    }

    // Returns the lines of the scene's materials, one for each. Also sets shape_materials_, the
    // keys that bind these materials to the mesh file's.
    std::string write_materials() {
        std::set<int> used;
        for (const MeshTriangle& triangle : mesh_.triangles) used.insert(triangle.material);
        if (used.contains(-1)) { // an OBJ file that names none
            shape_materials_ = ", \"material\": \"grey\"";
            notes_.push_back("its faces have no material: grey stands in");
            return "\n        \"grey\": {\"kind\": \"diffuse\", \"reflectance\": [0.5, 0.5, "
                   "0.5]}\n    ";
        }
        const std::vector<std::string> keys = material_keys(mesh_);
        std::map<std::string, std::vector<int>> parts; // indices of what it became
        for (const int i : used) parts[keys[std::size_t(i)]].push_back(i);
        std::string materials, map;
        for (const auto& [key, indices] : parts) {
            for (const int i : indices)
                glows_ = glows_ || is_emissive(mesh_.materials[std::size_t(i)].material);
            const MeshMaterial& first = mesh_.materials[std::size_t(indices[0])];
            const std::string name = quoted(key);
            const std::string text = indices.size() == 1 ? written(first) : "";
            if (text.empty()) {
                notes_.push_back(fmt::format(
                    "the material {} stays the file's own, {}; \"materials\" of the mesh can put "
                    "another in its place",
                    name,
                    first.picture >= 0   ? "with its picture"
                    : indices.size() > 1 ? "which varies over the surface"
                                         : "glass that glows"));
                continue;
            }
            materials +=
                fmt::format("{}\n        {}: {}", materials.empty() ? "" : ",", name, text);
            map += fmt::format("{}{}: {}", map.empty() ? "" : ", ", name, name);
        }
        if (map.empty()) return "";
        shape_materials_ = fmt::format(", \"materials\": {{{}}}", map);
        return materials + "\n    ";
    }

    std::string write_lights() {
        std::string lights;
        for (const MeshLight& light : mesh_.lights)
            if (!is_black(light.intensity))
                lights += fmt::format("{}\n        {{\"kind\": \"point\", \"position\": {}, "
                                      "\"intensity\": {}}}",
                                      lights.empty() ? "" : ",", array(light.position),
                                      array(DVec3(light.intensity)));
        if (!lights.empty())
            notes_.push_back("its lights' candela are taken as they are: --exposure of render, or "
                             "another intensity, makes the picture as bright as it should be");
        if (lights.empty() && glows_)
            notes_.push_back("only materials that glow light it; a sky is one more line in lights: "
                             "{\"kind\": \"environment\", \"radiance\": [1, 1, 1]}");
        if (lights.empty() && !glows_) {
            notes_.push_back("nothing in it shines: an even white sky lights it");
            lights = "\n        {\"kind\": \"environment\", \"radiance\": [1, 1, 1]}";
        }
        return lights.empty() ? "" : lights + "\n    ";
    }

    const Mesh& mesh_;
    const std::string& file_;
    std::string shape_materials_;
    bool glows_ = false;
    std::vector<std::string> notes_;
};

} // namespace

ImportedScene import_scene(const Mesh& mesh, const std::string& file, const std::string& title) {
    return Importer(mesh, file).scene(title);
}

} // namespace raylab::app
