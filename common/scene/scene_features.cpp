// Which features a scene uses, from its arrays.
#include "common/scene/scene_features.h"

#include "common/material/bsdf.h"
#include "common/scene/scene.h"

#include <utility>
#include <vector>

namespace raylab {

Features features_of(const Scene& scene) { return features_of(scene, scene.camera); }

Features features_of(const Scene& scene, const Camera& camera) {
    Features features = 0;
    const auto add_shapes = [&](const auto& shapes, Features shape) {
        for (const auto& s : shapes) { // only materials that some shape has count
            const Material& material = scene.materials[s.tags.material];
            features |= shape | feature_of(material.kind);
            if (material.texture >= 0) features |= feature::texture;
        }
    };
    add_shapes(scene.spheres, feature::sphere);
    add_shapes(scene.quads, feature::quad);
    add_shapes(scene.planes, feature::plane);
    add_shapes(scene.triangles, feature::triangle);
    if (!scene.corners.empty()) features |= feature::corners;
    if (!scene.corner_colours.empty()) features |= feature::vertex_colours;
    for (const Light& light : scene.lights) {
        if (light.kind == LightKind::point) {
            features |= feature::point_light;
        } else if (light.kind == LightKind::environment) {
            features |=
                scene.environment_map.empty() ? feature::environment : feature::environment_map;
        } else {
            features |= feature::area_light;
        }
    }
    if (camera.lens_radius > 0) features |= feature::lens;
    return features;
}

std::string feature_names(Features features) {
    std::vector<std::pair<Features, const char*>> names = {
        {feature::sphere, "sphere"},   {feature::quad, "quad"},
        {feature::plane, "plane"},     {feature::triangle, "triangle"},
        {feature::corners, "corners"}, {feature::texture, "texture"},
    };
    for (int k = 0; k < material_kinds; ++k)
        names.emplace_back(feature_of(MaterialKind(k)), name_of(MaterialKind(k)));
    names.insert(names.end(), {{feature::area_light, "area_light"},
                               {feature::point_light, "point_light"},
                               {feature::environment, "environment"},
                               {feature::environment_map, "environment_map"},
                               {feature::lens, "lens"},
                               {feature::vertex_colours, "vertex_colours"}});
    std::string text;
    for (const auto& [bit, name] : names)
        if (features & bit) text.append(text.empty() ? "" : " ").append(name);
    return text;
}

} // namespace raylab
