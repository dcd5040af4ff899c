// Any bytes as an OBJ file.
#include "common/load/mesh.h"
#include "common/load/scene_error.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        raylab::Mesh mesh =
            raylab::parse_obj({reinterpret_cast<const char*>(data), size}, "input.obj");
        raylab::compute_smooth_normals(mesh);
    } catch (const raylab::SceneError&) {
    }
    return 0;
}
