// Reflection and refraction of a direction at a normal. All vectors are unit and point away from
// the surface. PBR4e 9.3.1 (the law of specular reflection), 9.3.3 (refraction and Snell's law).
#pragma once

//[ withhold 01
//| #include "common/math/frame.h"
//]
#include "common/math/numbers.h"
#include "common/math/vec.h"

namespace raylab {

HD Vec3 reflect(Vec3 wo, Vec3 n) { return 2 * dot(wo, n) * n - wo; }

struct Refraction {
    Vec3 wi;    // points to the other side of the surface; never NaN
    bool total; // total internal reflection: no light is refracted, wi has no meaning
};

//[ withhold 01
// Requires dot(wo, n) >= 0. eta: index of refraction on the far side divided by that on wo's side.
//
// By Snell's law, the part of wi along the surface, t, is that of -wo divided by eta. The part
// along n follows from the unit length of wi. It is computed from |t| and not from dot(wo, n): so
// wi stays unit over a thousand refractions in a row, and is never normalised.
HD Refraction refract(Vec3 wo, Vec3 n, float eta) {
    const Vec3 t = -(wo - dot(wo, n) * n) / eta;
    const float sin2_t = dot(t, t);
    return {t - safe_sqrt(1 - sin2_t) * n, sin2_t >= 1};
}
//| namespace lab01 {
//| Vec3 refracted_direction(Vec3 wo, float eta); // task 1.6
//| }
//|
//| // Requires dot(wo, n) >= 0. eta: index of refraction on the far side over that on wo's. Yours,
//| // around the normal n.
//| HD Refraction refract(Vec3 wo, Vec3 n, float eta) {
//|     const Frame frame = Frame::around(n);
//|     const Vec3 wi = frame.to_world(lab01::refracted_direction(frame.to_local(wo), eta));
//|     const float cosine = dot(wo, n);
//|     return {wi, (1 - cosine) * (1 + cosine) >= eta * eta};
//| }
//]

} // namespace raylab
