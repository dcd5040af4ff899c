// What the tests that compare labs have in common: small scenes, renders with their paths, and the
// place where two of them part.
#pragma once

#include "app/labs.h"
#include "app/scene_changes.h"
#include "common/load/load.h"
#include "common/render/render.h"

#include <algorithm>
#include <cstring>

namespace raylab::app {

// A copy of the scene with a film of at most `side` pixels a side and few samples.
inline Scene small(const std::string& name, int side, std::uint32_t seed) {
    Scene scene = load_scene(find_scene(name));
    const double shrink = std::min(1.0, static_cast<double>(side) /
                                            std::max(scene.camera.width, scene.camera.height));
    set_film_size(scene.camera, std::max(1, static_cast<int>(scene.camera.width * shrink)),
                  std::max(1, static_cast<int>(scene.camera.height * shrink)));
    scene.render.seed = seed;
    return scene;
}

struct Traced {
    Film film;
    std::vector<std::vector<PathRecord>> records; // [iteration][pixel]
};

inline Traced trace(const std::string& lab, const Scene& scene, const MachineSettings& machine,
                    int spp) {
    const std::unique_ptr<Renderer> renderer = find_lab(lab).make(scene, machine);
    Traced traced;
    add_samples(*renderer, spp, [&](int) { traced.records.push_back(renderer->records()); });
    traced.film = renderer->film();
    return traced;
}

// In words: the first place where two renders differ.
inline std::string first_difference(const Traced& a, const Traced& b, int width) {
    for (std::size_t sample = 0; sample < a.records.size(); ++sample)
        for (std::size_t pixel = 0; pixel < a.records[sample].size(); ++pixel) {
            const PathRecord& x = a.records[sample][pixel];
            const PathRecord& y = b.records[sample][pixel];
            if (x.length != y.length || x.end != y.end || x.hits != y.hits ||
                x.shadow_rays != y.shadow_rays)
                return "pixel (" + std::to_string(pixel % width) + ", " +
                       std::to_string(pixel / width) + "), sample " + std::to_string(sample) +
                       ": lengths " + std::to_string(x.length) + " and " +
                       std::to_string(y.length) + ", shadow rays " + std::to_string(x.shadow_rays) +
                       " and " + std::to_string(y.shadow_rays);
        }
    return "";
}

} // namespace raylab::app
