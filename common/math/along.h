// A coordinate of a vector, by the number of its axis.
#pragma once

#include "common/math/hd.h"

namespace raylab {

// v[axis], for code that runs for every ray. It chooses one of three coordinates. With an index
// that is known at run time only, a GPU would keep the vector in its slow local memory, and a CPU
// would wait for the axis instead of predicting a branch. The function is always inlined, so in an
// unrolled loop over the axes it is one load. Compilers make GLM's operator a call in large files.
template <class Vector> HD_HOT auto along(const Vector& v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

} // namespace raylab
