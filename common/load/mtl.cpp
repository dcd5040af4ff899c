// MTL by tinyobjloader. The format (Alias|Wavefront, 1995) describes what programs of its time
// could draw; `illum` says how: 0 and 1 diffuse, 2 with a highlight, 3, 5 and 8 with reflections,
// 4, 6, 7 and 9 as glass.
#include "common/load/mtl.h"

#include "common/load/scene_error.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace raylab {
namespace {

// Clamps a value. Where the file has no number, tinyobjloader gives 0 or a value that is not
// finite.
float between(float value, float low, float high) {
    return std::isfinite(value) ? std::clamp(value, low, high) : low;
}

Vec3 colour(const tinyobj::real_t (&c)[3], float high = 1) {
    return Vec3(between(c[0], 0, high), between(c[1], 0, high), between(c[2], 0, high));
}

Material nearest_material(const tinyobj::material_t& mtl) {
    Material m;
    const Vec3 diffuse = colour(mtl.diffuse), specular = colour(mtl.specular);
    m.emission = colour(mtl.emission, 1e30f);
    const bool has_glass_model =
        mtl.illum == 4 || mtl.illum == 6 || mtl.illum == 7 || mtl.illum == 9;
    if ((has_glass_model || mtl.dissolve < 0.5f) && is_black(m.emission)) {
        m.kind = MaterialKind::glass;
        const Vec3 filter = colour(mtl.transmittance);
        m.reflectance = is_black(filter) ? Vec3(1) : filter;
        m.ior = mtl.ior > 1 ? between(mtl.ior, 1, 4) : 1.5f; // 1, the default, refracts nothing
        return m;
    }
    const bool has_reflections = mtl.illum == 3 || mtl.illum == 5 || mtl.illum == 8;
    if (has_reflections && is_black(diffuse) && !is_black(specular)) {
        m.kind = MaterialKind::mirror;
        m.reflectance = specular;
        return m;
    }
    m.reflectance = diffuse;
    if (is_black(specular) || mtl.illum == 0 || mtl.illum == 1) return m;
    m.kind = MaterialKind::phong;
    m.specular = specular;
    m.exponent = between(mtl.shininess, 0, 1e4f);
    // Together the two must not reflect more light than arrives.
    const float most = max_component(m.reflectance + m.specular);
    if (most > 1) {
        m.reflectance /= most;
        m.specular /= most;
    }
    return m;
}

std::string with_slashes(std::string path) {
    std::replace(path.begin(), path.end(), '\\', '/');
    return path;
}

} // namespace

MtlLibrary read_mtl(const std::vector<std::string>& files, const std::string& name,
                    const ReadNamedFile& read, Mesh& mesh) {
    MtlLibrary library;
    std::map<std::string, int> pictures; // -1: cannot be read
    const auto picture = [&](const std::string& file) {
        const auto [found, is_new] = pictures.try_emplace(file, -1);
        if (!is_new) return found->second;
        try {
            Picture texels = decode_picture(read(file), file);
            found->second = int(mesh.pictures.size());
            mesh.pictures.push_back(std::move(texels));
        } catch (const SceneError& error) {
            mesh.warnings.push_back(
                fmt::format("{}: a material goes without its picture: {}", name, error.what()));
        }
        return found->second;
    };
    for (const std::string& file : files) {
        std::istringstream text;
        try {
            text.str(read(with_slashes(file)));
        } catch (const SceneError& error) {
            mesh.warnings.push_back(fmt::format("{}: mtllib {}: {}", name, file, error.what()));
            continue;
        }
        std::map<std::string, int> index;
        std::vector<tinyobj::material_t> materials;
        std::string warning, error;
        tinyobj::LoadMtl(&index, &materials, &text, &warning, &error);
        for (const tinyobj::material_t& mtl : materials) {
            MeshMaterial material{mtl.name, nearest_material(mtl), -1};
            const bool shows_picture = material.material.kind == MaterialKind::diffuse ||
                                       material.material.kind == MaterialKind::phong;
            if (!mtl.diffuse_texname.empty() && shows_picture) {
                material.picture = picture(with_slashes(mtl.diffuse_texname));
                // Many programs write Kd 0 beside a picture, and mean the picture.
                if (material.picture >= 0 && is_black(material.material.reflectance))
                    material.material.reflectance = Vec3(1) - material.material.specular;
            }
            library.try_emplace(mtl.name, material);
        }
    }
    return library;
}

} // namespace raylab
