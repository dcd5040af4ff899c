// "First bounce cache, second bounce thrash": what the camera rays hit, kept from the first
// iteration to all that follow.
//
// Every iteration traces a camera ray through every pixel. If it is the same ray each time, it hits
// the same point, and the cache saves about one search in eight. If the rays differ, the cache is
// wrong: a jittered ray would shade a point that it does not see, so edges would stay jagged, and a
// lens would be as sharp as a pinhole. Then the cache is refused. Most scenes have jitter for
// anti-aliasing, so most scenes refuse it.
#pragma once

#include "common/geometry/ray.h"
#include "common/scene/scene.h"
#include "common/task/not_implemented.h"

#include <optional>
#include <string>

namespace raylab::lab03 {

// Says why camera rays differ from one iteration to the next, and what could be changed; nothing if
// they are always the same.
inline std::optional<std::string> no_first_bounce_cache(const Camera& camera,
                                                        const RenderSettings& render) {
    // Steps:
    // 1. A lens: say why each sample's ray differs, and what could be changed.
    // 2. Jitter: the same.
    // 3. Else there is nothing to be said.
    //[ task 3.4
    if (camera.lens_radius > 0)
        return "the camera has a lens: each sample starts elsewhere on it (lens_radius 0 is a "
               "pinhole)";
    if (render.jitter)
        return "camera rays are jittered within their pixel: each sample starts in another "
               "direction (--jitter false sends all through the middle, without anti-aliasing)";
    return std::nullopt;
    //| not_implemented("3.4", "no_first_bounce_cache()");
    //| return "task 3.4 is not implemented";
    //]
}

// A hit for each pixel, and whether it is known yet.
struct FirstBounceCache {
    Hit* hits = nullptr; // null: no cache
    bool filled = false; // by the iterations before
};

// The closest hit of the pixel's ray: `search()` finds it, unless it is a camera ray (bounce 0)
// whose hit is known.
template <class Search>
HD Hit cached_hit(const FirstBounceCache& cache, int bounce, std::uint32_t pixel,
                  const Search& search) {
    if (cache.hits == nullptr || bounce > 0) return search();
    // Steps:
    // 1. Not filled yet: search, and keep the hit of this pixel.
    // 2. Return what is kept.
    //[ task 3.4
    if (!cache.filled) cache.hits[pixel] = search();
    return cache.hits[pixel];
    //| not_implemented("3.4", "cached_hit()");
    //| return search();
    //]
}

} // namespace raylab::lab03
