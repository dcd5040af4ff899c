// Vectors are GLM's, under the field's names; the few functions GLM lacks are here.
#pragma once

#include "common/math/hd.h"

#define GLM_FORCE_XYZW_ONLY
#include <glm/glm.hpp>

#include <cmath>
#include <type_traits>

namespace raylab {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using DVec3 = glm::dvec3;
using Mat4 = glm::mat4;

// Device arrays are copied byte by byte.
static_assert(std::is_trivially_copyable_v<Vec3> && sizeof(Vec3) == 12);

using glm::cross;
using glm::dot;

HD float max_component(Vec3 v) { return glm::max(v.x, glm::max(v.y, v.z)); }
HD Vec3 abs(Vec3 v) { return Vec3(fabsf(v.x), fabsf(v.y), fabsf(v.z)); }
HD float length_squared(Vec3 v) { return dot(v, v); }
HD float length(Vec3 v) { return sqrtf(dot(v, v)); }

// One division by the length: scaling v by a power of two changes no bit of the result.
HD Vec3 normalize(Vec3 v) { return v / sqrtf(dot(v, v)); }

HD bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
HD bool is_black(Vec3 v) { return v.x == 0 && v.y == 0 && v.z == 0; }

// Rec. 709 luminance Y of linear RGB.
HD float luminance(Vec3 rgb) { return 0.2126f * rgb.x + 0.7152f * rgb.y + 0.0722f * rgb.z; }

} // namespace raylab
