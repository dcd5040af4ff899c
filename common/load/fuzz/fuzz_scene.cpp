// Any bytes as a scene file: a scene or a SceneError, and nothing else. The files it may name lie
// beside the seeds.
#include "common/load/load.h"
#include "common/scene/scene_features.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const std::string_view text(reinterpret_cast<const char*>(data), size);
        const raylab::Scene scene = raylab::parse_scene(text, SEEDS "/scene/input.json");
        raylab::feature_names(raylab::features_of(scene));
    } catch (const raylab::SceneError&) {
    }
    return 0;
}
