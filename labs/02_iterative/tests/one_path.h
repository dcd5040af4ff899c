// One path of the lab's loops, called as plain functions, for the tests of tasks 2.1 and 2.5.
#pragma once

#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/02_iterative/path.h"
#include "labs/02_iterative/whitted.h"

namespace raylab::lab02 {

inline constexpr Features tested =
    feature::sphere | feature::quad | feature::plane | feature::diffuse | feature::mirror |
    feature::glass | feature::area_light | feature::point_light | feature::environment;

// One sample of the radiance along the ray; sample k has numbers of its own.
inline Vec3 trace(const Scene& scene, const Ray& ray, std::uint32_t k = 0,
                  PathRecord* result = nullptr) {
    PathRecord record;
    const Sampler sampler = {SamplerKind::independent, 1, 0, k};
    const Vec3 radiance =
        scene.render.integrator == Integrator::path
            ? trace_path<tested>(view(scene), scene.render, sampler, ray, record)
            : trace_whitted<tested>(view(scene), scene.render, sampler, ray, record);
    if (result) *result = record;
    return radiance;
}

inline std::string settings(int depth, const std::string& strategy) {
    return fmt::format(R"("max_depth": {}, "spp": 1, "direct_light": "{}", "roulette": false)",
                       depth, strategy);
}

inline std::string whitted(int depth) {
    return fmt::format(R"("integrator": "whitted", "max_depth": {}, "spp": 1)", depth);
}

} // namespace raylab::lab02
