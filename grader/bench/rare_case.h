// The rare cases: "there are a few rare edge cases where this approach does not provide a
// performance boost. Can you think of any?" What was measured of each, and how it is written: the
// megakernel, the wavefront without compaction, and with it.
#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace raylab::bench {

// What a wavefront did, a sample of the whole image.
struct WavefrontCosts {
    double seconds = 0; // median of the rounds
    double iterations = 0, launches = 0, rays = 0, blocks = 0;
    double batches = 0;  // 0 if a launch traces several bounces: then they are not counted
    double removing = 0; // share of the time in compaction and sorting
    double between = 0;  // share of the time in no stage: launching, copying, waiting
};

struct RareCaseRow {
    std::string name, scene, why;
    int width, height;
    std::optional<double> megakernel; // seconds a sample, if the tree has one
    WavefrontCosts without, with;
};

nlohmann::ordered_json to_json(const std::vector<RareCaseRow>& rows);

// Two lines a case, without compaction and with it, a header first; RFC 4180.
std::string to_csv(const std::vector<RareCaseRow>& rows);

// For people: the header, and the lines of one case.
std::string rare_case_header();
std::string to_table(const RareCaseRow& row);

// The section of the page, from to_json()'s array.
std::string rare_cases_html(const nlohmann::ordered_json& rows);

} // namespace raylab::bench
