// What the environment's variables ask of the machine.
#pragma once

#include "common/simt/options.h"

namespace raylab::simt {

// RAYLAB_ORDER is forward, reverse, random or random:SEED; RAYLAB_WORKERS a number of threads.
// Another order ends the program with a message.
Options options_of_environment();

// Whether reports go to stderr, and a leak to the program's exit status: not where the environment
// says RAYLAB_REPORTS=0, for whoever reads the findings has them already.
bool print_reports();

} // namespace raylab::simt
