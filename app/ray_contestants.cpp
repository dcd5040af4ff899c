#include "app/ray_contestants.h"

#include "app/lab04_rays.h"

namespace raylab::app {

std::vector<std::string> ray_contestant_names() {
    std::vector<std::string> names = {"brute", "embree", "embree_robust"};
    for (const bench::RayContestant& contestant : lab04_ray_contestants())
        names.push_back(contestant.name);
    return names;
}

bench::RayContestant ray_contestant(const std::string& name) {
    if (name == "brute") return bench::brute_force();
    if (name == "embree") return bench::embree(false);
    if (name == "embree_robust") return bench::embree(true);
    for (const bench::RayContestant& contestant : lab04_ray_contestants())
        if (contestant.name == name) return contestant;
    throw bench::ContestantError("there is no structure '" + name + "'");
}

} // namespace raylab::app
