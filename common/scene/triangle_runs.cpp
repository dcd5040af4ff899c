#include "common/scene/triangle_runs.h"

#include "common/scene/halving.h"

namespace raylab {

void cut_into_runs(std::vector<Triangle>& triangles, int first, std::vector<TriangleRun>& runs) {
    // Three times the centroid, in double: no overflow.
    const auto centroid = [](const Triangle& t, int axis) {
        return double(t.v[0][axis]) + double(t.v[1][axis]) + double(t.v[2][axis]);
    };
    halve_into_runs(triangles.begin() + first, triangles.end(), triangles_per_run, centroid);
    for (int begin = first; begin < int(triangles.size()); begin += triangles_per_run) {
        TriangleRun run{{}, begin, std::min(triangles_per_run, int(triangles.size()) - begin)};
        for (int i = begin; i < begin + run.count; ++i)
            for (const Vec3& v : triangles[i].v) run.bounds.include(v);
        runs.push_back(run);
    }
}

} // namespace raylab
