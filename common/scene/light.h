// A light, as plain data: something that light sampling can choose.
#pragma once

#include "common/math/vec.h"

namespace raylab {

enum class LightKind : int { sphere, quad, triangle, point, environment };

struct Light {
    LightKind kind;
    int shape;      // sphere, quad, triangle: index into that array of SceneView; else -1
    Vec3 position;  // point: world position
    Vec3 intensity; // point: radiant intensity, power per solid angle (W/sr per channel)
};

} // namespace raylab
