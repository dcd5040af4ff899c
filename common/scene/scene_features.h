// The features that a scene uses, as a set.
#pragma once

#include "common/math/features.h"

#include <string>

namespace raylab {

struct Scene;

// Materials count if some shape has them.
Features features_of(const Scene& scene);

// "sphere quad diffuse area_light": for the ledger and for people.
std::string feature_names(Features features);

} // namespace raylab
