// One mesh: every structure is built, every kind of ray traced, in turns; answers compared.
//
// In each round every contestant traces the same rays once, and each round begins with the next
// contestant. So whatever else the machine does affects all alike, and ratios are formed within a
// round.
#pragma once

#include "grader/bench/rays/ray_sets.h"
#include "grader/bench/statistics.h"

#include <functional>
#include <optional>

namespace raylab::bench {

struct RaceOptions {
    std::vector<RayKind> kinds{std::begin(all_ray_kinds), std::end(all_ray_kinds)};
    int rounds = 5;
    int builds = 5; // timed, of each structure
    int threads = 1;
    std::uint32_t seed = 1;
    std::string baseline;        // the contestant to which ratios refer
    int verify = 64;             // rays of each kind that are also answered by brute force
    double least_seconds = 0.01; // a contestant traces again in a round until it took this long
};

// Two answers differ if only one of them is a hit, or if their t differ by more than this share.
// Two exact contestants' answers differ already if a bit of t differs, or the triangle.
constexpr double tolerated_t = 1e-4;
// Rays that graze an edge may have either answer from a contestant that is not exact.
constexpr double tolerated_share = 1e-4;

struct RayCell {
    RayKind kind = RayKind::primary;
    Measured mrays;                 // million rays a second
    int differing = 0;              // answers, from the truth's
    int verified = 0, wrong = 0;    // compared with brute force; not equal
    bool agrees = false;            // few enough of both
    std::optional<Measured> ratio;  // over the baseline; only if both agree
    std::optional<RayCounts> a_ray; // of a ray, on average
};

struct RayRow {
    std::string name, title;
    std::string failure; // a sentence if there are no figures
    bool is_exact = false;
    Measured build_seconds;
    double bytes_per_triangle = 0;
    std::vector<RayCell> cells; // one for each kind
};

struct RayRace {
    std::string mesh, left_out;
    int triangles = 0;
    std::string truth;           // whose answers the others' are compared with
    std::vector<int> ray_counts; // of each kind
    std::vector<RayRow> rows;
};

// How many steps `after_step` is told of.
int race_steps(const std::vector<RayContestant>& contestants, const RaceOptions& options);

// Answers are compared with those of the first exact contestant that takes part, or of the first if
// none is exact. This contestant also traces the rays from hit to hit. A contestant that fails, or
// has too many tests to make, becomes a row that says so. Throws ContestantError if nobody is left.
RayRace race(const RayMesh& mesh, const std::vector<RayContestant>& contestants,
             const RaceOptions& options, const std::function<void()>& after_step = {});

} // namespace raylab::bench
