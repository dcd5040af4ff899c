// The stages of the wavefront: lab 03's, with the walks.
#pragma once

#include <array>

namespace raylab::lab04 {

enum class Stage : int {
    generate,
    walk,
    intersect,
    shade,
    shadow_walk,
    shadow,
    compact,
    accumulate
};
inline constexpr std::array stage_names = {"generate",    "walk",   "intersect", "shade",
                                           "shadow walk", "shadow", "compact",   "accumulate"};

} // namespace raylab::lab04
