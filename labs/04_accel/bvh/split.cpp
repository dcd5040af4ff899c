#include "labs/04_accel/bvh/split.h"

#include "common/math/index.h"
#include "common/task/not_implemented.h"
#include "labs/04_accel/leaf/triangle_pack.h"

#include <algorithm>
#include <array>

namespace raylab::lab04 {
namespace {

constexpr int bins = 32;

struct Bin {
    Bounds box;
    // References that start in this slice, and that end in it. For a cut between triangles both are
    // where the centre is.
    int starts = 0, ends = 0;
};
using Bins = std::array<Bin, bins>;

// The slices of [low, high] along an axis.
struct Slices {
    float low, high, scale;

    Slices(const Bounds& box, int axis)
        : low(box.low[axis]), high(box.high[axis]),
          scale(static_cast<float>(bins * (1 - 1e-6) / (double(high) - low))) {}

    int operator()(float x) const { return index_of((x - low) * scale, bins); }
    float begin(int slice) const { return low + (high - low) * (static_cast<float>(slice) / bins); }
};

bool has_extent(const Bounds& box, int axis) {
    const float low = box.low[axis], high = box.high[axis];
    return high > low && std::isfinite(high - low);
}

Bounds common(const Bounds& a, const Bounds& b) {
    return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

// The best plane between two of the bins, if it beats `best`.
void choose_plane(const Bins& bin, int axis, Split& best) {
    // Steps:
    // 1. From the right: for each plane the box and the number of all that lies in the bins behind
    //    it.
    // 2. From the left, plane by plane: the box and the number of all before it.
    // 3. The plane's cost; one with nothing on a side is none.
    // 4. Keep the plane if it costs less than the best, with the overlap of the two boxes.
    //[ task 4.9
    std::array<Bounds, bins> right_box;
    std::array<int, bins> right_count;
    Bounds box;
    int count = 0;
    for (int i = bins - 1; i > 0; --i) {
        box.include(bin[i].box);
        count += bin[i].ends;
        right_box[i] = box;
        right_count[i] = count;
    }
    box = {};
    count = 0;
    for (int plane = 1; plane < bins; ++plane) {
        if (is_empty(bin[plane - 1].box)) continue; // the same halves as at the plane before
        box.include(bin[plane - 1].box);
        count += bin[plane - 1].starts;
        if (count == 0 || right_count[plane] == 0) continue;
        const double cost = half_area(box) * packs_for(count) +
                            half_area(right_box[plane]) * packs_for(right_count[plane]);
        if (cost >= best.cost) continue;
        const Bounds both = common(box, right_box[plane]);
        best = {cost, axis, plane, 0, is_empty(both) ? 0 : half_area(both)};
    }
    //| not_implemented("4.9", "choose_plane()");
    //]
}

// Puts the part of the triangle that lies in `box` into the boxes of the bins, slice by slice.
// Plain float will do, because these boxes only tell which plane is best; cut_through() has
// margins.
void chop(const Triangle& triangle, const Bounds& box, int axis, const Slices& slice, Bins& bin) {
    const float low = box.low[axis], high = box.high[axis];
    const int last = slice(high);
    if (slice(low) == last) return bin[last].box.include(box);
    const auto include = [&](int i, Vec3 p) {
        bin[i].box.include(glm::min(glm::max(p, box.low), box.high));
    };
    for (int i = 0; i < 3; ++i) {
        Vec3 a = triangle.v[i], b = triangle.v[i == 2 ? 0 : i + 1];
        if (a[axis] > b[axis]) std::swap(a, b);
        if (a[axis] > high || b[axis] < low) continue;
        const Vec3 slope = (b - a) / (b[axis] - a[axis]);
        const auto at = [&](float plane) { return a + slope * (plane - a[axis]); };
        int in = slice(std::max(a[axis], low));
        const int end = slice(std::min(b[axis], high));
        include(in, a[axis] < low ? at(low) : a);
        for (; in < end; ++in) {
            const Vec3 p = at(slice.begin(in + 1));
            include(in, p), include(in + 1, p);
        }
        include(end, b[axis] > high ? at(high) : b);
    }
}

// A lower bound for the cost of all planes through the triangles. On each side of a plane lies at
// least the box of the triangles that are wholly on that side, and no triangle is chopped to find
// it. Chopping is most of the work, and is left out where even this bound is too much. A bound of 0
// is right too, only slow.
double least_cost([[maybe_unused]] std::span<const BuildItem> items, [[maybe_unused]] int axis,
                  [[maybe_unused]] const Slices& slice) {
    // Steps:
    // 1. Sort the boxes into bins twice: by where they begin, and by where they end.
    // 2. Left of a plane lies at least the box of those that end before it, and at least as many as
    //    begin before it; right of it in the same way.
    // 3. Return the least of all planes' two sides together.
    //[ task 4.9
    Bins low, high; // by where boxes begin, and by where they end
    for (const BuildItem& item : items) {
        Bin &b = low[slice(item.box.low[axis])], &e = high[slice(item.box.high[axis])];
        b.box.include(item.box), ++b.starts;
        e.box.include(item.box), ++e.ends;
    }
    const auto side = [](const Bounds& box, int count) {
        return is_empty(box) ? 0 : half_area(box) * packs_for(count);
    };
    std::array<double, bins> right;
    Bounds box;
    int count = 0;
    for (int i = bins - 1; i > 0; --i) {
        box.include(low[i].box);
        count += high[i].ends;
        right[i] = side(box, count);
    }
    box = {};
    count = 0;
    double least = infinity;
    for (int plane = 1; plane < bins; ++plane) {
        box.include(high[plane - 1].box);
        count += low[plane - 1].starts;
        least = std::min(least, side(box, count) + right[plane]);
    }
    return least;
    //| return 0;
    //]
}

} // namespace

Bounds centres_of(std::span<const BuildItem> items) {
    Bounds centres;
    for (const BuildItem& item : items)
        centres.include({item.centre(0), item.centre(1), item.centre(2)});
    return centres;
}

Split best_cut_between(std::span<const BuildItem> items, const Bounds& centres) {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!has_extent(centres, axis)) continue;
        const Slices slice(centres, axis);
        Bins bin;
        // Steps:
        // 1. For each item: the bin of the slice that has its centre takes in the whole of its box.
        // 2. It counts there as beginning and as ending.
        //[ task 4.9
        for (const BuildItem& item : items) {
            Bin& b = bin[slice(item.centre(axis))];
            b.box.include(item.box);
            ++b.starts, ++b.ends;
        }
        //| not_implemented("4.9", "best_cut_between()");
        //]
        choose_plane(bin, axis, best);
    }
    return best;
}

std::size_t cut_between(Items items, const Bounds& centres, const Split& split) {
    const Slices slice(centres, split.axis);
    const auto middle = std::partition(items.begin(), items.end(), [&](const BuildItem& item) {
        return slice(item.centre(split.axis)) < split.plane;
    });
    return middle - items.begin();
}

Split best_cut_through(std::span<const BuildItem> items, const Bounds& box,
                       const std::vector<Triangle>& triangles, double most_cost) {
    Split best;
    best.cost = most_cost;
    for (int axis = 0; axis < 3; ++axis) {
        if (!has_extent(box, axis)) continue;
        const Slices slice(box, axis);
        if (least_cost(items, axis, slice) >= best.cost) continue;
        Bins bin;
        for (const BuildItem& item : items) {
            ++bin[slice(item.box.low[axis])].starts;
            ++bin[slice(item.box.high[axis])].ends;
            chop(triangles[item.index], item.box, axis, slice, bin);
        }
        choose_plane(bin, axis, best);
        if (best.axis == axis) best.position = slice.begin(best.plane);
    }
    return best;
}

void cut_through(std::span<const BuildItem> items, const std::vector<Triangle>& triangles,
                 const KdClip& clip, const Split& split, std::vector<BuildItem>& left,
                 std::vector<BuildItem>& right) {
    for (const BuildItem& item : items) {
        const float low = item.box.low[split.axis], high = item.box.high[split.axis];
        if (high <= split.position) {
            left.push_back(item);
        } else if (low >= split.position) {
            right.push_back(item);
        } else {
            BuildItem below = item, above = item;
            clip.cut(triangles[item.index], item.box, split.axis, split.position, below.box,
                     above.box);
            if (!is_empty(below.box)) left.push_back(below);
            if (!is_empty(above.box)) right.push_back(above);
        }
    }
}

} // namespace raylab::lab04
