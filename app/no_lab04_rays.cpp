#include "app/lab04_rays.h"

namespace raylab::app {

std::vector<bench::RayContestant> lab04_ray_contestants() { return {}; }

} // namespace raylab::app
