// A whole bench of rays, and what is written of it: rays.csv and rays.json for programs, a table
// for the terminal, and the page rays.html.
#pragma once

#include "grader/bench/machine.h"
#include "grader/bench/rays/race.h"

#include <nlohmann/json.hpp>

namespace raylab::bench {

struct RaysBench {
    Machine machine;
    std::string command;
    RaceOptions options;
    int width = 0, height = 0;  // of the film: primary rays
    std::string scaling;        // the procedural mesh whose size rises from race to race, or empty
    std::vector<RayRace> races; // one a mesh
    std::vector<std::string> notes; // contestants that are absent
};

// How a contestant did over all meshes and kinds of rays.
struct RaySummary {
    std::string name;
    // The geometric mean of its ratios, round by round; nothing if one of them is missing, since a
    // mean over the rest would flatter.
    std::optional<Measured> mean;
    double worst = 0, best = 0; // cell
    std::string why_not;        // "5 of 15 ratios: ..."
};
std::vector<RaySummary> summaries(const RaysBench& bench);

// Figures that are not known become null.
nlohmann::ordered_json to_json(const RaysBench& bench);

// One line for each mesh, contestant and kind of rays, a header first; RFC 4180.
std::string to_csv(const RaysBench& bench);

// For people.
std::string to_table(const RayRace& race, const std::string& baseline);
std::string to_table(const std::vector<RaySummary>& summaries, const std::string& baseline);

// `json`: as to_json makes it; `machine`: one line for people.
std::string rays_page_html(const nlohmann::ordered_json& json, const std::string& machine);

// rays.csv, rays.json and rays.html in `folder`. Throws FileError.
void write_rays_bench(const RaysBench& bench, const std::string& folder);

} // namespace raylab::bench
