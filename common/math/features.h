// Which features a scene uses. Kernels are templates over this set: what a scene does not use is
// not in its kernel, so a diffuse Cornell box pays nothing for glass, meshes or lenses.
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
constexpr Features diffuse = 1u << 6;
constexpr Features mirror = 1u << 7;
constexpr Features glass = 1u << 8;
constexpr Features phong = 1u << 9;
constexpr Features conductor = 1u << 10;
constexpr Features rough_dielectric = 1u << 11;
constexpr Features area_light = 1u << 12;
constexpr Features point_light = 1u << 13;
constexpr Features environment = 1u << 14; // constant
constexpr Features environment_map = 1u << 15;
constexpr Features lens = 1u << 16;
constexpr Features vertex_colours = 1u << 17; // a factor at each corner of a triangle
constexpr Features all = (1u << 18) - 1;
} // namespace feature

} // namespace raylab
