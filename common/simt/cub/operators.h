// CUB's operators, and what its collectives of a block have in common.
#pragma once

#include "common/simt/api/warp.h"
#include "common/simt/groups/site_of.h"
#include "common/simt/index.h"

#include <utility>

namespace cub {

struct Sum {
    template <class T> T operator()(const T& a, const T& b) const { return a + b; }
};
struct Max {
    template <class T> T operator()(const T& a, const T& b) const { return a < b ? b : a; }
};
struct Min {
    template <class T> T operator()(const T& a, const T& b) const { return b < a ? b : a; }
};
struct Difference {
    template <class T> T operator()(const T& a, const T& b) const { return a - b; }
};
struct Equality {
    template <class T> bool operator()(const T& a, const T& b) const { return a == b; }
};
struct Inequality {
    template <class T> bool operator()(const T& a, const T& b) const { return !(a == b); }
};

// A place in memory that keeps what lies there: shared memory has no constructors.
struct NullType {};

namespace detail {

using raylab::simt::Where;

inline int thread_rank() {
    return int((threadIdx.z * blockDim.y + threadIdx.y) * blockDim.x + threadIdx.x);
}

inline void meet(const char* operation, Where where) {
    raylab::simt::sync_block(raylab::simt::site_of(operation, where), 0);
}

// A value of each thread of a block, in shared memory. As in CUB, a barrier must stand before the
// next collective that uses the same storage.
template <class T, int threads> struct ValuesOfThreads { T values[threads]; };

} // namespace detail
} // namespace cub
