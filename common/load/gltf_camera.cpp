#include "common/load/gltf_camera.h"

#include <fmt/format.h>

#include <numbers>

namespace raylab {

std::optional<MeshCamera> read_gltf_camera(const Node& root, const Node& node,
                                           const Transform& to_world, GltfLosses& losses) {
    const auto index = node.find("camera");
    if (!index) return std::nullopt;
    const auto array = root.find("cameras");
    const std::vector<Node> cameras = array ? array->elements() : std::vector<Node>{};
    if (index->integer() < 0 || index->integer() >= int(cameras.size()))
        index->fail(fmt::format("camera {} does not exist; the file has {}", index->integer(),
                                cameras.size()));
    const Node& camera = cameras[std::size_t(index->integer())];
    if (camera.at("type").word({"perspective", "orthographic"}) == "orthographic") {
        losses.add("orthographic cameras", "node");
        return std::nullopt;
    }
    const Node perspective = camera.at("perspective");
    MeshCamera result;
    result.name = node.has("name")     ? node.at("name").string()
                  : camera.has("name") ? camera.at("name").string()
                                       : "";
    result.position = to_world.translation;
    result.forward = to_world.linear * DVec3(0, 0, -1);
    result.up = to_world.linear * DVec3(0, 1, 0);
    const Node yfov = perspective.at("yfov");
    result.vfov_deg = yfov.positive() * 180 / std::numbers::pi;
    if (result.vfov_deg >= 180) yfov.fail_expected("an angle below pi");
    if (const auto aspect = perspective.find("aspectRatio")) result.aspect = aspect->positive();
    return result;
}

} // namespace raylab
