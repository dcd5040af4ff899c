// The features that a scene uses, as a set of bits. Kernels are templates over this set. A kernel
// has no code for features that its scene does not use, so a diffuse Cornell box pays nothing for
// glass, meshes or lenses.
#pragma once

#include "common/math/hd.h"

namespace raylab {

using Features = unsigned;

namespace feature {
constexpr Features sphere = 1u << 0;
constexpr Features quad = 1u << 1;
constexpr Features plane = 1u << 2;
constexpr Features triangle = 1u << 3;
constexpr Features corners = 1u << 4; // interpolated normals or texture coordinates
constexpr Features texture = 1u << 5;
constexpr Features area_light = 1u << 6;
constexpr Features point_light = 1u << 7;
constexpr Features environment = 1u << 8; // constant
constexpr Features environment_map = 1u << 9;
constexpr Features lens = 1u << 10;
constexpr Features vertex_colours = 1u << 11; // a factor at each corner of a triangle
constexpr Features first_material = 1u << 12; // the kinds of material follow (material.h)
constexpr Features all = ~0u;
} // namespace feature

} // namespace raylab
