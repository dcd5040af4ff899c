// The order of shapes in an array: neighbours there are neighbours in space.
#pragma once

#include "common/math/numbers.h"

#include <algorithm>

namespace raylab {

// Recursive halving along the longest axis of the box of the centres, at multiples of `run` from
// the front, so that all runs but the last are full. Within a run ids ascend. The order depends on
// centres and ids alone. centre(shape, axis): a finite double, or a multiple; T has tags.id.
template <class Iterator, class Centre>
void halve_into_runs(Iterator begin, Iterator end, int run, const Centre& centre) {
    const auto count = end - begin;
    if (count <= run) {
        std::sort(begin, end, [](const auto& a, const auto& b) { return a.tags.id < b.tags.id; });
        return;
    }
    int longest = 0;
    double extent = -1;
    for (int axis = 0; axis < 3; ++axis) {
        double low = infinity, high = -infinity;
        for (auto shape = begin; shape != end; ++shape) {
            low = std::min(low, centre(*shape, axis));
            high = std::max(high, centre(*shape, axis));
        }
        if (high - low > extent) {
            extent = high - low;
            longest = axis;
        }
    }
    const auto runs = (count + run - 1) / run;
    const auto middle = begin + runs / 2 * run;
    std::nth_element(begin, middle, end, [&centre, longest](const auto& a, const auto& b) {
        const double x = centre(a, longest), y = centre(b, longest);
        return x < y || (x == y && a.tags.id < b.tags.id);
    });
    halve_into_runs(begin, middle, run, centre);
    halve_into_runs(middle, end, run, centre);
}

} // namespace raylab
