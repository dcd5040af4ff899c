// The surface area heuristic; see kd/split.h.
#include "labs/04_accel/kd/split.h"

#include "common/task/not_implemented.h"

#include <algorithm>
#include <array>

namespace raylab::lab04 {

namespace {

constexpr int bins = 32;
constexpr std::size_t few = 16; // up to so many, every place is tried

double at(const Vec3& v, int axis) { return v[axis]; }

// Tries planes, and keeps the best.
class Search {
  public:
    Search(const Bounds& cell, int n, const KdCosts& costs) : cell_(cell), n_(n), costs_(costs) {
        const DVec3 d = DVec3(cell.high) - DVec3(cell.low);
        area_ = d.x * d.y + d.y * d.z + d.z * d.x;
    }

    // From now on planes are across this axis.
    void across(int axis) {
        axis_ = axis;
        const DVec3 d = DVec3(cell_.high) - DVec3(cell_.low);
        const double u = d[(axis + 1) % 3], v = d[(axis + 2) % 3];
        // A part of the cell of length l along the axis has the area u v + (u + v) l.
        faces_ = u * v;
        around_ = u + v;
    }

    // below, above: triangles that reach into the part of the cell on that side.
    void consider(float plane, int below, int above) {
        // Steps:
        // 1. A plane that is not strictly inside the cell is refused, and one with all on both
        //    sides.
        // 2. Find the two parts' areas: faces_, and around_ times the part's length.
        // 3. Compute the cost (kd/split.h), times the empty factor if one side has nothing.
        // 4. Keep the plane if it costs less than the best.
        //[ task 4.1
        const double low = at(cell_.low, axis_), high = at(cell_.high, axis_);
        if (!(plane > low && plane < high) || (below == n_ && above == n_)) return;
        const double area_below = faces_ + around_ * (plane - low),
                     area_above = faces_ + around_ * (high - plane);
        double cost =
            costs_.step + (area_below * packs_for(below) + area_above * packs_for(above)) / area_;
        if (below == 0 || above == 0) cost *= costs_.empty_factor;
        if (cost < best.cost) best = {axis_, plane, cost};
        //| not_implemented("4.1", "best_plane()");
        //]
    }

    KdPlane best;

  private:
    Bounds cell_;
    int n_;
    KdCosts costs_;
    double area_; // of the cell: half the surface, as all areas here
    int axis_ = 0;
    double faces_ = 0, around_ = 0; // u v and u + v, see across()
};

// The axis is a constant for the compiler, so v[axis] is a load and not a choice of three.
template <int axis> void try_every_place(std::span<const KdReference> references, Search& search) {
    // Steps:
    // 1. Sort along the axis where boxes begin, and apart from them where boxes end.
    // 2. Go up through both lists; the next plane is at whichever comes first.
    // 3. At a plane: first pass the ends up to it, then consider it, then pass what begins there.
    //[ task 4.1
    const int n = int(references.size());
    std::array<float, few> begin, end;
    for (int i = 0; i < n; ++i) {
        begin[i] = references[i].box.low[axis];
        end[i] = references[i].box.high[axis];
    }
    std::sort(begin.begin(), begin.begin() + n);
    std::sort(end.begin(), end.begin() + n);
    // Upwards through both: before a plane i have begun, up to it j have ended.
    for (int i = 0, j = 0; i < n || j < n;) {
        const float plane = i < n && begin[i] < end[j] ? begin[i] : end[j];
        while (j < n && end[j] <= plane) ++j;
        search.consider(plane, i, n - j);
        while (i < n && begin[i] <= plane) ++i;
    }
    //| not_implemented("4.1", "try_every_place()");
    //]
}

template <int axis>
void try_bins(std::span<const KdReference> references, const Bounds& cell, Search& search) {
    // Steps:
    // 1. Count in which of the bins each box begins, and in which it ends.
    // 2. Consider the place where the first box begins, and the place where the last one ends.
    // 3. Go up the planes between bins: what began in the bin before is below from now on, what
    //    ended there is no longer above. Consider each plane with both counts.
    //[ task 4.1
    const float low = cell.low[axis], high = cell.high[axis];
    const float width = (high - low) / bins;
    const float per_width = 1 / width;
    std::array<int, bins> begin{}, end{};
    float first = high, last = low;
    const auto bin = [&](float x) { return int(clamp((x - low) * per_width, 0, bins - 1)); };
    for (const KdReference& reference : references) {
        const float from = reference.box.low[axis], to = reference.box.high[axis];
        ++begin[bin(from)];
        ++end[bin(to)];
        first = std::min(first, from);
        last = std::max(last, to);
    }
    const int n = int(references.size());
    search.consider(first, 0, n);
    search.consider(last, n, 0);
    for (int k = 1, below = 0, above = n; k < bins; ++k) {
        below += begin[k - 1];
        above -= end[k - 1];
        search.consider(low + k * width, below, above);
    }
    //| not_implemented("4.1", "try_bins()");
    //]
}

template <int axis>
void try_axis(std::span<const KdReference> references, const Bounds& cell, Search& search) {
    search.across(axis);
    if (references.size() <= few) {
        try_every_place<axis>(references, search);
    } else {
        try_bins<axis>(references, cell, search);
    }
}

} // namespace

KdPlane best_plane(std::span<const KdReference> references, const Bounds& cell,
                   const KdCosts& costs) {
    Search search(cell, int(references.size()), costs);
    try_axis<0>(references, cell, search);
    try_axis<1>(references, cell, search);
    try_axis<2>(references, cell, search);
    return search.best;
}

} // namespace raylab::lab04
