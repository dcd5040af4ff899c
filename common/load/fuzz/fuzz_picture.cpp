// Any bytes as an image file.
#include "common/load/environment_map.h"
#include "common/load/scene_error.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        raylab::environment_cdf(raylab::decode_picture(bytes, "input"));
    } catch (const raylab::SceneError&) {
    }
    return 0;
}
