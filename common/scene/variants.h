// The closed set of kernel variants: a scene runs in the first that covers its features.
//
// With more variants, each would be a little faster and every build slower. The bench measures what
// a general kernel costs.
#pragma once

#include "common/material/material.h"

namespace raylab {

namespace variant {
// A diffuse Cornell box: quads under an area light.
constexpr Features matte = feature::quad | feature::diffuse | feature::area_light;
// The classic spheres: mirror and glass, point and area lights.
constexpr Features classic = matte | feature::sphere | feature::plane | feature::mirror |
                             feature::glass | feature::point_light;
constexpr Features everything = feature::all;
} // namespace variant

constexpr bool covers(Features kernel, Features scene) { return (scene & ~kernel) == 0; }

// Calls f.template operator()<F>() with the smallest variant F that covers the scene's features. A
// build with RAYLAB_VARIANTS=one has the largest variant only. It compiles in a third of the time;
// builds in which nothing is timed use it.
template <class Function>
decltype(auto) with_variant([[maybe_unused]] Features scene, Function&& f) {
#if !defined(RAYLAB_ONE_VARIANT)
    if (covers(variant::matte, scene)) return f.template operator()<variant::matte>();
    if (covers(variant::classic, scene)) return f.template operator()<variant::classic>();
#endif
    return f.template operator()<variant::everything>();
}

} // namespace raylab
