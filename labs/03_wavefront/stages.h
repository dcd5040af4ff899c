// The stages of the wavefront, in the order of the lecture's steps.
#pragma once

#include <array>

namespace raylab::lab03 {

enum class Stage : int { generate, intersect, sort, shade, shadow, compact, accumulate };
inline constexpr std::array stage_names = {"generate", "intersect", "sort",      "shade",
                                           "shadow",   "compact",   "accumulate"};

} // namespace raylab::lab03
