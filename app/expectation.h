// Do renders meet what their scene file promises?
#pragma once

#include "common/image/image.h"
#include "common/scene/scene.h"

namespace raylab::app {

struct ExpectationResult {
    bool met;
    double value, expected, standard_error;
    std::string sentence; // for people
};

// replicates: two renders or more that differ in their seed.
ExpectationResult check_expectation(const Expectation& expectation,
                                    const std::vector<Image>& replicates);

} // namespace raylab::app
