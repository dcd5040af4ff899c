// Plane and bounding parallelogram of each quad, with what rounding them to float costs.
#include "common/scene/quad_groups.h"

#include <algorithm>
#include <array>

namespace raylab {
namespace {

// How far the values f(v) of the corners range.
template <class Function> std::array<double, 2> range(const Quad& quad, const Function& f) {
    double low = infinity, high = -infinity;
    for (const Vec3& v : quad.v) {
        low = std::min(low, f(DVec3(v)));
        high = std::max(high, f(DVec3(v)));
    }
    return {low, high};
}

void set_lane(QuadGroup& group, int lane, const Quad& quad) {
    for (const Vec3& v : quad.v) group.extent = std::max(group.extent, max_component(abs(v)));

    // All in terms of the rounded vectors: the rounding of these costs nothing.
    const DVec3 normal(quad.normal);
    const auto [below, above] = range(quad, [&](DVec3 p) { return dot(normal, p); });
    group.offset[lane] = static_cast<float>((below + above) / 2);
    const double bend = std::max(above - group.offset[lane], group.offset[lane] - below);
    group.bend[lane] = std::nextafter(static_cast<float>(bend), infinity);

    group.vague[lane] = quad.parallelogram ? 0 : infinity;
    for (int axis = 0; axis < 3; ++axis) group.normal[axis][lane] = quad.normal[axis];
    for (int i = 0; i < 2; ++i) {
        DVec3 vector = quad.across[i];
        // Where v[2] is not opposite v[0] the parallelogram is stretched to hold it.
        const auto reach = range(quad, [&](DVec3 p) { return dot(vector, p - DVec3(quad.v[0])); });
        vector = DVec3(Vec3(vector / (reach[1] - reach[0])));
        const double start = range(quad, [&](DVec3 p) { return dot(vector, p); })[0];
        group.start[i][lane] = static_cast<float>(start);
        for (int axis = 0; axis < 3; ++axis)
            group.across[i][axis][lane] = static_cast<float>(vector[axis]);
        const DVec3 size = glm::abs(vector);
        group.steepness[lane] =
            std::max(group.steepness[lane], static_cast<float>(size.x + size.y + size.z));
    }
}

} // namespace

std::vector<QuadGroup> group_quads(const std::vector<Quad>& quads) {
    std::vector<QuadGroup> groups;
    const int size = static_cast<int>(quads.size());
    for (int first = 0; first < size; first += quads_per_group) {
        QuadGroup& group = groups.emplace_back();
        group.first = first;
        group.count = std::min(quads_per_group, size - first);
        for (int lane = 0; lane < group.count; ++lane) set_lane(group, lane, quads[first + lane]);
    }
    return groups;
}

} // namespace raylab
