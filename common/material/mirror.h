// A perfect mirror: all light comes from the mirrored direction (a delta lobe). PBR4e 9.3.1.
#pragma once

#include "common/material/bsdf_sample.h"

namespace raylab {

// wo above the surface. f and pdf hold the same delta, so f cos / pdf is the reflectance.
HD BsdfSample sample_mirror(Vec3 reflectance, Vec3 wo) {
    return {Vec3(-wo.x, -wo.y, wo.z), reflectance, 0, true, true};
}

template <> struct Bsdf<MaterialKind::mirror> {
    static constexpr const char* name = "mirror";
    static constexpr bool is_clear = false;
    HD static bool is_specular(const Material&) { return true; }
    HD static BsdfValue evaluate(const Material&, Vec3, Vec3, Vec3) { return {}; }
    HD static BsdfSample sample(const Material&, Vec3 reflectance, Vec3 wo, float, Vec2) {
        return sample_mirror(reflectance, wo);
    }
};

} // namespace raylab
