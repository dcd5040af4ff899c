// The same scene rendered several times with seeds of their own: how far apart the images lie is
// their error, measured and not assumed.
#pragma once

#include "app/labs.h"

namespace raylab::app {

struct ReplicateJob {
    const Lab* lab;
    Scene scene; // its spp is that of one replicate
    MachineSettings machine;
    std::uint32_t first_seed = 1; // replicate r draws with seed first_seed + r
};

Image render_replicate(const ReplicateJob& job, int r);

// Mean over replicates, and the standard error of that mean per pixel, from their spread:
//     var = sum (x_r - mean)^2 / (R (R - 1)).
// Right for any sampler, also where samples of one replicate are not independent.
class ReplicateMean {
  public:
    void add(const Image& image);
    Image mean() const; // at least two replicates

  private:
    int count_ = 0;
    Image last_; // size and provenance
    std::vector<DVec3> sum_, sum_squares_;
};

// Do the replicates meet what the scene file promises? One sentence for people.
struct ExpectationResult {
    bool met;
    double value, expected, standard_error;
    std::string sentence;
};

ExpectationResult check_expectation(const Expectation& expectation,
                                    const std::vector<Image>& replicates);

} // namespace raylab::app
