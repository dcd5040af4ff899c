// One scene, one lab, judged: independent replicates against the reference, and the closed forms
// that the scene promises.
#pragma once

#include "app/expectation.h"
#include "app/labs.h"
#include "grader/judge/independent.h"
#include "grader/judge/same_paths.h"

#include <optional>

namespace raylab::app {

struct JudgedScene {
    std::string lab, scene, title, reason;
    bool passed = true;
    IndependentResult judgement;
    std::vector<ExpectationResult> expectations;
    std::optional<SamePathsResult> same_paths; // against the lab before, if there is one
    Image image;                               // mean over the replicates
    Image first;        // the first replicate alone, to hold against other labs
    Ledger ledger;      // of the first replicate
    double seconds = 0; // tracing, all replicates
};

// The scene's own samples are shared out among 16 replicates. Replicate r draws with seed
// first_seed + r. Throws UsageError if the reference is of another scene or size.
JudgedScene judge_scene(const Lab& lab, const Scene& scene, const Image& reference,
                        const MachineSettings& machine, std::uint32_t first_seed);

// The same random numbers must give the same image: two labs' first replicates, path by path.
void judge_against(JudgedScene& judged, const JudgedScene& other);

// scenes/references/NAME.exr. Throws UsageError if there is none, or if it was made of another
// version of the scene.
Image load_reference(const Scene& scene);

} // namespace raylab::app
