// The section `lights`: point lights and the environment. Surfaces that glow are lights by their
// material.
#include "common/load/environment_map.h"
#include "common/load/keys.h"
#include "common/load/scene_builder.h"
#include "common/load/scene_error.h"

namespace raylab {

void SceneBuilder::read_lights(const Node& lights) {
    std::optional<Node> environment; // the last of all lights, wherever it stands
    for (const Node& node : lights.elements()) {
        node.expect_object();
        const Node kind = node.at("kind");
        const std::string word = kind.word({"point", "environment"});
        node.expect_keys(scene_keys().at("light " + word), "a light of kind " + word);
        if (word == "environment") {
            if (environment)
                node.fail("expected at most one environment, found a second; remove one");
            environment = node;
            continue;
        }
        const Node intensity = node.at("intensity");
        Light light{LightKind::point, -1, Vec3(node.at("position").vec3()), intensity.rgb()};
        if (is_black(light.intensity)) {
            scene_.warnings.push_back(intensity.place() + ": a black light is left out");
            continue;
        }
        scene_.lights.push_back(light);
    }
    if (environment) read_environment(*environment);
}

void SceneBuilder::read_environment(const Node& node) {
    if (node.has("radiance") == node.has("file"))
        node.fail(std::string("expected either a radiance (constant) or a file (map), found ") +
                  (node.has("file") ? "both; remove one" : "neither"));
    if (const auto radiance = node.find("radiance")) {
        if (const auto scale = node.find("scale"))
            scale->fail("scale belongs to a map: multiply the radiance instead");
        if (const auto rotate = node.find("rotate_deg"))
            rotate->fail("rotate_deg belongs to a map: a constant environment is the same from "
                         "everywhere");
        scene_.environment_radiance = radiance->rgb();
        if (is_black(scene_.environment_radiance)) {
            scene_.warnings.push_back(radiance->place() + ": a black environment is left out");
            return;
        }
    } else {
        const Node file = node.at("file");
        const std::string bytes = read_named_file(file);
        Picture map;
        try {
            map = decode_picture(bytes, (folder_ / file.string()).string());
        } catch (const SceneError& error) {
            file.fail(error.what());
        }
        if (const auto rotate = node.find("rotate_deg"))
            scene_.environment_turn = rotate_map(map, rotate->number());
        EnvironmentCdf cdf = environment_cdf(map);
        scene_.environment_radiance =
            Vec3(node.has("scale") ? float(node.at("scale").positive()) : 1);
        scene_.environment_width = map.width;
        scene_.environment_height = map.height;
        scene_.environment_map = std::move(map.texels);
        scene_.environment_row_cdf = std::move(cdf.row);
        scene_.environment_column_cdf = std::move(cdf.column);
    }
    scene_.environment_light = int(scene_.lights.size());
    scene_.lights.push_back({LightKind::environment, -1, Vec3(0), Vec3(0)});
}

} // namespace raylab
