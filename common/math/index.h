// From a number to an index or a count. A plain conversion is undefined where the whole part does
// not fit: a NaN or an infinity, which files and rounding bring about, becomes any index at all.
#pragma once

#include "common/math/hd.h"

namespace raylab {

// The whole part of x if it is in [0, count - 1]. Smaller numbers and NaN give 0, larger numbers
// give count - 1. count >= 1.
template <class Real> HD int index_of(Real x, int count) {
    if (!(x >= 0)) return 0;
    const int i = x < Real(0x1p31) ? static_cast<int>(x) : count;
    return i < count ? i : count - 1;
}

} // namespace raylab
