// Recursive halving along the longest axis of the centroids' box, at multiples of the run's length,
// so that all runs but the last are full.
#include "common/scene/triangle_runs.h"

#include <algorithm>

namespace raylab {
namespace {

// Three times the centroid, in double: no overflow.
double centroid(const Triangle& t, int axis) {
    return double(t.v[0][axis]) + double(t.v[1][axis]) + double(t.v[2][axis]);
}

using Iterator = std::vector<Triangle>::iterator;

void halve(Iterator begin, Iterator end) {
    const auto count = end - begin;
    if (count <= triangles_per_run) {
        std::sort(begin, end,
                  [](const Triangle& a, const Triangle& b) { return a.tags.id < b.tags.id; });
        return;
    }
    int longest = 0;
    double extent = -1;
    for (int axis = 0; axis < 3; ++axis) {
        double low = infinity, high = -infinity;
        for (auto t = begin; t != end; ++t) {
            low = std::min(low, centroid(*t, axis));
            high = std::max(high, centroid(*t, axis));
        }
        if (high - low > extent) {
            extent = high - low;
            longest = axis;
        }
    }
    const auto runs = (count + triangles_per_run - 1) / triangles_per_run;
    const auto middle = begin + runs / 2 * triangles_per_run;
    std::nth_element(begin, middle, end, [longest](const Triangle& a, const Triangle& b) {
        const double x = centroid(a, longest), y = centroid(b, longest);
        return x < y || (x == y && a.tags.id < b.tags.id);
    });
    halve(begin, middle);
    halve(middle, end);
}

} // namespace

void cut_into_runs(std::vector<Triangle>& triangles, int first, std::vector<TriangleRun>& runs) {
    halve(triangles.begin() + first, triangles.end());
    for (int begin = first; begin < int(triangles.size()); begin += triangles_per_run) {
        TriangleRun run{{}, begin, std::min(triangles_per_run, int(triangles.size()) - begin)};
        for (int i = begin; i < begin + run.count; ++i)
            for (const Vec3& v : triangles[i].v) run.bounds.include(v);
        runs.push_back(run);
    }
}

} // namespace raylab
