#include "app/ray_contestants.h"

#include <functional>
#include <utility>

namespace raylab::app {

namespace {

using Maker = std::pair<std::string, std::function<bench::RayContestant()>>;

const std::vector<Maker>& makers() {
    static const std::vector<Maker> all = {
        {"brute", [] { return bench::brute_force(); }},
        {"embree", [] { return bench::embree(false); }},
        {"embree_robust", [] { return bench::embree(true); }},
    };
    return all;
}

} // namespace

const std::vector<std::string>& ray_contestant_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> result;
        for (const auto& [name, make] : makers()) result.push_back(name);
        return result;
    }();
    return names;
}

bench::RayContestant ray_contestant(const std::string& name) {
    for (const auto& [known, make] : makers())
        if (known == name) return make();
    throw bench::ContestantError("there is no structure '" + name + "'");
}

} // namespace raylab::app
