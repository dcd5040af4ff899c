// What light sampling gives to an integrator. PBR4e 12.1.1 (the light interface).
#pragma once

#include "common/math/numbers.h"
#include "common/math/vec.h"

namespace raylab {

// A point on a light, chosen to light a receiver at `from`. World space.
struct LightSample {
    Vec3 p = Vec3(0);        // the point; unused for the environment
    float error = 0;         // bound on how far along n rounding puts p off the light
    Vec3 n = Vec3(0);        // the light's unit normal at p, on the side that faces `from`
    Vec3 wi = Vec3(0);       // unit, from the receiver to the light
    float distance = 0;      // from `from` to p; infinity for the environment
    Vec3 radiance = Vec3(0); // arrives if nothing is in the way; point: intensity / distance^2
    float pdf = 0;      // density of wi per solid angle, of this light alone; 1 for a delta light
    bool delta = false; // true for a point light, which no ray can hit
    bool valid = false; // false: this sample carries no light
};

// Turns the density of a point on a surface into the density of the direction to it: an area dA
// with normal n at distance r covers the solid angle dA |cos| / r^2. 0 where the surface is seen
// edge on; light sampling rejects those points.
HD float solid_angle_pdf(float area_pdf, float distance2, float abs_cosine) {
    return abs_cosine > 0 ? area_pdf * distance2 / abs_cosine : 0.0f;
}

// The sample of an area light for its point p, which was chosen with density area_pdf per area.
// error, n: at p, as in LightSample, but n may be on either side. Lights emit from both sides.
HD_HOT LightSample light_sample_at(Vec3 from, Vec3 p, float error, Vec3 n, float area_pdf,
                                   Vec3 radiance) {
    const Vec3 d = p - from;
    const float distance2 = length_squared(d), distance = sqrtf(distance2);
    const Vec3 wi = d / distance;
    const float cosine = -dot(wi, n);
    const float pdf = solid_angle_pdf(area_pdf, distance2, fabsf(cosine));
    return {p,   error, copysignf(1.0f, cosine) * n, wi, distance, radiance,
            pdf, false, pdf > 0 && pdf < infinity};
}

} // namespace raylab
