#include "grader/bench/rays/ray_contestant.h"

namespace raylab::bench {

RayContestant embree(bool) {
    throw ContestantError(
        "raylab was built without Embree: install libembree-dev, then configure anew");
}

} // namespace raylab::bench
