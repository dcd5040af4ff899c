// A lab as a contestant of the bench.
#pragma once

#include "app/labs.h"
#include "grader/bench/contestant.h"

namespace raylab::app {

// The contestant renders in this process. Its `bytes` are the growth of the heap: the film, the
// records, the paths and the renderer's copy of the scene; on the CPU machine also the arrays that
// lie in device memory on a GPU. The scene must outlive the contestant.
bench::Contestant lab_contestant(const Lab& lab, const Scene& scene,
                                 const MachineSettings& machine);

} // namespace raylab::app
