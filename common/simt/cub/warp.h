// cub::WarpReduce and cub::WarpScan: the values of `width` neighbouring lanes combined, in the
// order of the lanes. Of a reduction only the first lane gets the result, as CUB promises.
#pragma once

#include "common/simt/cub/operators.h"
#include "common/simt/groups/reduce.h"

namespace cub {

namespace detail {

template <int width> auto lanes_of_warp() {
    return cooperative_groups::tiled_partition<unsigned(width)>(
        cooperative_groups::this_thread_block());
}

} // namespace detail

template <class T, int width = 32, int = 0> class WarpReduce {
    using Where = detail::Where;

  public:
    using TempStorage = NullType;
    explicit WarpReduce(TempStorage&) {}

    template <class Combine> T Reduce(T value, Combine combine, Where where = Where::here()) {
        const auto lanes = detail::lanes_of_warp<width>();
        const T result = cooperative_groups::reduce(lanes, value, combine, where);
        return lanes.thread_rank() == 0 ? result : value;
    }
    T Sum(T value, Where where = Where::here()) { return Reduce(value, cub::Sum(), where); }
};

template <class T, int width = 32, int = 0> class WarpScan {
    using Where = detail::Where;

  public:
    using TempStorage = NullType;
    explicit WarpScan(TempStorage&) {}

    template <class Combine>
    void InclusiveScan(T in, T& out, Combine combine, Where where = Where::here()) {
        out =
            cooperative_groups::inclusive_scan(detail::lanes_of_warp<width>(), in, combine, where);
    }
    void InclusiveSum(T in, T& out, Where where = Where::here()) {
        InclusiveScan(in, out, cub::Sum(), where);
    }
    void ExclusiveSum(T in, T& out, Where where = Where::here()) {
        out = cooperative_groups::exclusive_scan(detail::lanes_of_warp<width>(), in, cub::Sum(),
                                                 where);
    }
};

} // namespace cub
