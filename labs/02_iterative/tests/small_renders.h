// Small images that the tests of tasks 2.2 to 2.4 and 2.6 let the lab draw.
#pragma once

#include "common/task/small_scene.h"
#include "labs/02_iterative/renderer.h"

namespace raylab::lab02 {

inline Film render(const Scene& scene, const MachineSettings& machine, int iterations) {
    const std::unique_ptr<Renderer> renderer = make_renderer(scene, machine);
    for (int i = 0; i < iterations; ++i) renderer->add_iteration();
    return renderer->film();
}

// What the machine says of a kernel that it has ended; empty if it ended none.
template <class Act> std::string error_of(const Act& act) {
    try {
        act();
        return "";
    } catch (const std::exception& error) {
        return error.what();
    }
}

// Nothing but sky: every sample is (1, 2, 3).
inline Scene sky(int width, int height) {
    return task::small_scene({.materials = R"("a": {"kind": "mirror", "reflectance": [1, 1, 1]})",
                              .shapes = "",
                              .lights = R"({"kind": "environment", "radiance": [1, 2, 3]})",
                              .width = width,
                              .height = height});
}

// A floor, unevenly lit: every pixel is noisy. The view is so narrow that all pixels see the same
// point, but for the last digits: what their values differ in are the random numbers.
inline Scene noisy(int side, std::uint32_t seed) {
    return task::small_scene(
        {.materials = R"("floor": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
            "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [3, 3, 3]})",
         .shapes =
             R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "material": "floor"},
            {"kind": "quad", "material": "lamp",
             "vertices": [[-3, 3, 1], [3, 3, 1], [3, 4, 4], [-3, 4, 4]]})",
         .render = fmt::format(R"("max_depth": 3, "spp": 1, "seed": {})", seed),
         .camera =
             R"("position": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 1e-5)",
         .width = side,
         .height = side});
}

} // namespace raylab::lab02
