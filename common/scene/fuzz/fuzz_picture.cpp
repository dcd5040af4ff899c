// Any bytes as an image file.
#include "common/scene/environment_map.h"
#include "common/scene/scene_error.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        raylab::environment_cdf(raylab::decode_picture(bytes, "input"));
    } catch (const raylab::SceneError&) {
    }
    return 0;
}
