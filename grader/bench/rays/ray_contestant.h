// Who takes part in a bench of rays: anything that builds something over triangles and then says
// what rays meet.
#pragma once

#include "common/cli/joined_threads.h"
#include "common/geometry/ray.h"
#include "common/geometry/shapes.h"
#include "grader/bench/contestant.h"

#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace raylab::bench {

// What a ray meets first in (0, t_max): the triangle's place in the mesh, and t; -1 and infinity if
// it meets nothing.
struct RayAnswer {
    float t = infinity;
    int triangle = -1;
};

// Summed over rays. A node is what is read at once: a pair of boxes, eight boxes, a split plane.
struct RayCounts {
    double nodes = 0, triangles = 0;
};

// What was built. The tracing functions return their seconds. The time begins with rays in the
// structure's own memory and ends with answers there, so a GPU's time has no copies in it. There
// are as many answers as rays.
class RayStructure {
  public:
    virtual ~RayStructure() = default;
    virtual double closest(std::span<const Ray> rays, std::span<RayAnswer> answers) const = 0;
    virtual double any(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const = 0;

    // Trace the same rays, untimed, and count. Nothing if the structure does not count.
    virtual std::optional<RayCounts> count_closest(std::span<const Ray>) const { return {}; }
    virtual std::optional<RayCounts> count_any(std::span<const Ray>) const { return {}; }
};

struct BuiltStructure {
    std::unique_ptr<RayStructure> structure;
    // The time from triangles in memory to a structure that can trace; NaN where nothing is built.
    double seconds = 0;
    double bytes = 0; // held besides the triangles given
};

struct RayContestant {
    std::string name;  // "embree"
    std::string title; // "Embree 3.13.5, rtcIntersect1, medium quality"
    // Whether answers are those of common/geometry to the bit, the lowest triangle at equal t.
    // Others are compared with a tolerance.
    bool is_exact = false;
    double most_tests = std::numeric_limits<double>::infinity(); // rays times triangles, in a run
    // tags.id of a triangle is its place. The triangles outlive the structure. Throws
    // ContestantError.
    std::function<BuiltStructure(std::span<const Triangle>, int threads)> build;
};

// Every triangle, with the test that all labs share: the truth.
RayContestant brute_force();

// Intel's Embree (I. Wald et al., "Embree: A Kernel Framework for Efficient CPU Ray Tracing",
// SIGGRAPH 2014), one ray at a time; `robust`: with its flag for watertight edges. Throws
// ContestantError if it was not there when raylab was built.
RayContestant embree(bool robust);

inline double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Calls part(begin, end) for as many parts of [0, n) as there are threads, each on its own; the
// seconds that took.
template <class Part> double seconds_in_parts(std::size_t n, int threads, const Part& part) {
    const auto start = std::chrono::steady_clock::now();
    {
        JoinedThreads others;
        const auto count = static_cast<std::size_t>(threads);
        for (std::size_t i = 1; i < count; ++i)
            others.start([&part, n, i, count] { part(n * i / count, n * (i + 1) / count); });
        part(0, n / count);
    }
    return seconds_since(start);
}

} // namespace raylab::bench
