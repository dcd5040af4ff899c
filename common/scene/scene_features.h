// The features that a scene uses, as a set.
#pragma once

#include "common/math/features.h"

#include <string>

namespace raylab {

struct Camera;
struct Scene;

// Materials count if some shape has them. The camera is the scene's unless another is given.
Features features_of(const Scene& scene);
Features features_of(const Scene& scene, const Camera& camera);

// "sphere quad diffuse area_light": for the ledger and for people.
std::string feature_names(Features features);

} // namespace raylab
