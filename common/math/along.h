// A coordinate of a vector, by the number of its axis.
#pragma once

#include "common/math/hd.h"

namespace raylab {

// v[axis], for what runs for every ray. By a choice of three: for an index that is known at run
// time only, a GPU would put the vector into its slow local memory, and a CPU would wait for the
// axis where it can predict a branch. It is always inlined, so in an unrolled loop over the axes it
// is one load; GLM's operator is a call where a file has many of them.
template <class Vector> HD_HOT auto along(const Vector& v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

} // namespace raylab
