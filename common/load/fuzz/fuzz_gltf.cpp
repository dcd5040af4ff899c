// Any bytes as a glTF or GLB file; a file it names has a few bytes.
#include "common/load/mesh.h"
#include "common/load/scene_error.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const auto read = [](const std::string&) { return std::string(36, '\x3f'); };
        raylab::Mesh mesh =
            raylab::parse_gltf({reinterpret_cast<const char*>(data), size}, "input.gltf", read);
        raylab::compute_smooth_normals(mesh);
    } catch (const raylab::SceneError&) {
    }
    return 0;
}
