#include "common/load/gltf_light.h"

#include <fmt/format.h>

#include <vector>

namespace raylab {

std::optional<MeshLight> read_gltf_light(const Node& root, const Node& node,
                                         const Transform& to_world, GltfLosses& losses) {
    const auto of_node = node.find("extensions");
    const auto named = of_node ? of_node->find("KHR_lights_punctual") : std::nullopt;
    if (!named) return std::nullopt;
    const auto of_file = root.find("extensions");
    const auto extension = of_file ? of_file->find("KHR_lights_punctual") : std::nullopt;
    const std::vector<Node> lights =
        extension ? extension->at("lights").elements() : std::vector<Node>{};
    const Node index = named->at("light");
    if (index.integer() < 0 || index.integer() >= int(lights.size()))
        index.fail(fmt::format("light {} does not exist; the file has {}", index.integer(),
                               lights.size()));
    const Node& light = lights[std::size_t(index.integer())];
    const std::string type = light.at("type").word({"point", "spot", "directional"});
    if (type != "point") {
        losses.add(type + " lights", "node");
        return std::nullopt;
    }
    if (light.has("range")) losses.add("ranges of lights", "node");
    const Vec3 colour = light.has("color") ? light.at("color").rgb() : Vec3(1);
    const double intensity = light.has("intensity") ? light.at("intensity").not_negative() : 1;
    const MeshLight result{to_world.translation, float(intensity) * colour};
    if (!is_finite(result.intensity))
        light.fail("expected an intensity of at most 3.4e38 (single precision) in each colour");
    return result;
}

} // namespace raylab
