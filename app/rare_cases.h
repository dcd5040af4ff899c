// The rare cases: "there are a few rare edge cases where this approach does not provide a
// performance boost. Can you think of any?" Each case, measured: the megakernel, the wavefront
// without compaction, and with it.
#pragma once

#include "app/labs.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace raylab::app {

struct RareCase {
    const char* name;
    const char* scene; // bundled
    WavefrontSettings wavefront;
    const char* why;
};

// The usual case first, to compare with.
const std::vector<RareCase>& rare_cases();

// What a wavefront did, a sample of the whole image.
struct WavefrontCosts {
    double seconds = 0; // median of the rounds
    double iterations = 0, launches = 0, rays = 0, blocks = 0, batches = 0;
    double removing = 0; // share of the time in compaction and sorting
    double between = 0;  // share of the time in no stage: launching, copying, waiting
};

struct RareCaseRow {
    const RareCase* shown;
    int width, height;
    double megakernel; // seconds a sample: lab 02
    WavefrontCosts without, with;
};

// Labs 02 and 03 take turns, `rounds` times.
RareCaseRow measure(const RareCase& shown, const MachineSettings& machine, int rounds);

// For people: the header, and the lines of one case.
std::string rare_case_header();
std::string to_table(const RareCaseRow& row);

nlohmann::ordered_json to_json(const RareCaseRow& row);

} // namespace raylab::app
