// One contestant on one scene: the figures of a bench. Evaluated in evaluate.cpp, written in
// table.cpp (text, CSV), json.cpp and page.cpp.
#pragma once

#include "grader/bench/error.h"
#include "grader/bench/statistics.h"

#include <optional>
#include <string>
#include <vector>

namespace raylab::bench {

struct BouncePoint {
    double paths_share; // of the paths that began, those alive here, 0 to 1
    std::optional<double>
        lanes_share; // share of a GPU's lanes at work; nothing where none are counted
};

struct ErrorPoint {
    int spp;
    double seconds; // of rendering, start-up taken out: spp * slope
    double rel_mse; // median over rounds
    double mse;
};

struct Row {
    std::string name, title;
    std::string failure; // a sentence if there are no figures: absent, failed, not exportable
    bool is_baseline = false;

    // The error check. A row that does not agree has no ratios.
    bool agrees = false;
    std::string verdict;              // "images differ: ..." if not
    std::vector<std::string> remarks; // what to know about these figures

    Measured ms_per_spp;        // slope of time over spp
    Measured start_up;          // seconds at 0 spp
    Measured mse, rel_mse;      // at the most samples
    Measured efficiency;        // 1 / (MSE seconds), start-up taken out; 1 / (radiance^2 s)
    Measured exponent;          // of relMSE over spp: -1 for independent samples
    Measured seconds_to_target; // from relMSE = C / n, C at the most samples
    Bias bias;                  // against the truth; NaN for the contestant that is the truth
    std::optional<Measured> speed_ratio, efficiency_ratio; // over the baseline in the same round

    std::vector<ErrorPoint> points;
    double rays_per_second = 0; // camera, scattered and shadow rays; 0: not counted
    double bytes_per_path = 0;  // held by the renderer, its copy of the scene included; 0: unknown
    std::vector<BouncePoint> bounces;
};

struct SceneResult {
    std::string name, title, hash;
    int width = 0, height = 0, max_depth = 0;
    std::string truth; // what errors are measured from, in a sentence
    std::vector<Row> rows;
};

} // namespace raylab::bench
