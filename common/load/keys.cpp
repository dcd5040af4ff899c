// The keys of scene format version 1.
#include "common/load/keys.h"

namespace raylab {

const std::map<std::string, std::vector<std::string>>& scene_keys() {
    static const std::map<std::string, std::vector<std::string>> keys{
        {"scene",
         {"version", "title", "reason", "camera", "film", "render", "materials", "shapes", "lights",
          "expect", "$schema"}},
        {"camera", {"position", "look_at", "up", "vfov_deg", "lens_radius", "focus_distance"}},
        {"film", {"width", "height"}},
        {"render",
         {"integrator", "max_depth", "spp", "seed", "sampler", "direct_light", "roulette",
          "jitter"}},
        {"material diffuse", {"kind", "reflectance", "reflectance_texture", "emission"}},
        {"material mirror", {"kind", "reflectance", "emission"}},
        {"material glass", {"kind", "ior", "fresnel", "reflectance"}},
        {"material phong", {"kind", "reflectance", "specular", "exponent", "emission"}},
        {"material conductor",
         {"kind", "eta", "k", "reflectance", "alpha", "microfacets", "fresnel", "emission"}},
        {"material rough_dielectric", {"kind", "ior", "alpha", "microfacets", "reflectance"}},
        {"shape sphere", {"kind", "center", "radius", "material", "transform"}},
        {"shape box", {"kind", "low", "high", "material", "transform"}},
        {"shape quad", {"kind", "vertices", "material", "transform"}},
        {"shape plane", {"kind", "point", "normal", "material"}},
        {"shape triangle", {"kind", "vertices", "material", "transform"}},
        {"shape mesh", {"kind", "file", "smooth", "material", "materials", "lights", "transform"}},
        {"shape procedural", {"kind", "mesh", "triangles", "seed", "material", "transform"}},
        {"transform", {"scale", "rotate", "translate"}},
        {"rotate", {"axis", "angle_deg"}},
        {"light point", {"kind", "position", "intensity"}},
        {"light environment", {"kind", "radiance", "file", "scale", "rotate_deg"}},
        {"expect", {"formula", "value", "tolerance", "region", "spp"}},
    };
    return keys;
}

} // namespace raylab
