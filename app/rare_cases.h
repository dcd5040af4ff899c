// The rare cases: "there are a few rare edge cases where this approach does not provide a
// performance boost. Can you think of any?" Each case, measured: the megakernel, the wavefront
// without compaction, and with it.
#pragma once

#include "app/labs.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace raylab::app {

// What a wavefront did, a sample of the whole image.
struct WavefrontCosts {
    double seconds = 0; // median of the rounds
    double iterations = 0, launches = 0, rays = 0, blocks = 0, batches = 0;
    double removing = 0; // share of the time in compaction and sorting
    double between = 0;  // share of the time in no stage: launching, copying, waiting
};

struct RareCaseRow {
    std::string name, scene, why;
    int width, height;
    std::optional<double> megakernel; // seconds a sample: lab 02, if this tree has it
    WavefrontCosts without, with;
};

// Lab 02 and the two wavefronts take turns, `rounds` times, case by case; `show` gets each row when
// it is there. Throws UsageError in a tree without lab 03.
std::vector<RareCaseRow> measure_rare_cases(const MachineSettings& machine, int rounds,
                                            const std::function<void(const RareCaseRow&)>& show);

// For people: the header, and the lines of one case.
std::string rare_case_header();
std::string to_table(const RareCaseRow& row);

nlohmann::ordered_json to_json(const std::vector<RareCaseRow>& rows);

} // namespace raylab::app
