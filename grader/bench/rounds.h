// The runs themselves. Contestants take turns, so that whatever else the machine does meanwhile
// meets all of them alike, and ratios within a round can be trusted where seconds cannot.
#pragma once

#include "grader/bench/contestant.h"

#include <vector>

namespace raylab::bench {

struct Plan {
    std::vector<int> spp = {4,
                            16}; // at least two, rising: time against spp gives slope and start-up
    int rounds = 5;
    std::uint32_t first_seed = 1; // every run draws with a seed of its own
};

// All that a contestant drew.
struct Turns {
    std::string name, title;
    std::string failure;                   // a sentence if it failed; it then took no further part
    std::vector<std::vector<Drawn>> drawn; // [round][which of Plan::spp]
};

// First every contestant draws once, untimed. In each round every contestant then draws at every
// spp. The contestant that begins is the next one in each round. `after_run` is called after each
// run with the number of runs done.
std::vector<Turns> take_turns(const std::vector<Contestant>& contestants, const Plan& plan,
                              const std::function<void(int)>& after_run = {});

} // namespace raylab::bench
