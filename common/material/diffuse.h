// Lambert's diffuse reflection: f = albedo / pi, the same for all directions. PBR4e 9.2.
#pragma once

#include "common/material/bsdf_sample.h"
#include "common/sampling/warp.h"

namespace raylab {

// wo, wi above the surface. Choosing wi with density cos/pi cancels f cos to the albedo.
HD BsdfValue evaluate_diffuse(Vec3 albedo, Vec3 wi) {
    return {albedo * (inv_pi * wi.z), cosine_hemisphere_pdf(wi.z)};
}

HD BsdfSample sample_diffuse(Vec3 albedo, Vec2 u) {
    const Vec3 wi = sample_cosine_hemisphere(u);
    return {wi, albedo, cosine_hemisphere_pdf(wi.z), false, wi.z > 0};
}

} // namespace raylab
