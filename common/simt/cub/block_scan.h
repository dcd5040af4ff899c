// cub::BlockScan: the values of a block's threads combined up to each thread, itself included or
// not. Without a first value the exclusive scan of thread 0 is T(), which CUB leaves undefined.
#pragma once

#include "common/simt/cub/operators.h"

namespace cub {

enum BlockScanAlgorithm { // all the same here
    BLOCK_SCAN_RAKING,
    BLOCK_SCAN_RAKING_MEMOIZE,
    BLOCK_SCAN_WARP_SCANS
};

template <class T, int X, BlockScanAlgorithm = BLOCK_SCAN_RAKING, int Y = 1, int Z = 1, int = 0>
class BlockScan {
    static constexpr int threads = X * Y * Z;
    using Where = detail::Where;

  public:
    using TempStorage = detail::ValuesOfThreads<T, threads>;

    explicit BlockScan(TempStorage& storage) : storage_(storage) {}

    void InclusiveSum(T in, T& out, Where where = Where::here()) {
        T all;
        InclusiveScan(in, out, cub::Sum(), all, where);
    }
    void InclusiveSum(T in, T& out, T& all, Where where = Where::here()) {
        InclusiveScan(in, out, cub::Sum(), all, where);
    }
    template <class Combine>
    void InclusiveScan(T in, T& out, Combine combine, Where where = Where::here()) {
        T all;
        InclusiveScan(in, out, combine, all, where);
    }
    template <class Combine>
    void InclusiveScan(T in, T& out, Combine combine, T& all, Where where = Where::here()) {
        bring("BlockScan::InclusiveScan()", in, where);
        out = up_to(detail::thread_rank() + 1, combine);
        all = up_to(threads, combine);
    }

    void ExclusiveSum(T in, T& out, Where where = Where::here()) {
        T all;
        ExclusiveScan(in, out, T(), cub::Sum(), all, where);
    }
    void ExclusiveSum(T in, T& out, T& all, Where where = Where::here()) {
        ExclusiveScan(in, out, T(), cub::Sum(), all, where);
    }
    template <class Combine>
    void ExclusiveScan(T in, T& out, T first, Combine combine, Where where = Where::here()) {
        T all;
        ExclusiveScan(in, out, first, combine, all, where);
    }
    // `all`: of all threads, without `first`.
    template <class Combine>
    void ExclusiveScan(T in, T& out, T first, Combine combine, T& all,
                       Where where = Where::here()) {
        bring("BlockScan::ExclusiveScan()", in, where);
        const int rank = detail::thread_rank();
        out = rank == 0 ? first : combine(first, up_to(rank, combine));
        all = up_to(threads, combine);
    }

    // Several values a thread, those of thread 0 first.
    template <int items>
    void InclusiveSum(const T (&in)[items], T (&out)[items], Where where = Where::here()) {
        T before;
        ExclusiveSum(sum_of(in), before, where);
        for (int i = 0; i < items; ++i) out[i] = before = before + in[i];
    }
    template <int items>
    void ExclusiveSum(const T (&in)[items], T (&out)[items], Where where = Where::here()) {
        T all;
        ExclusiveSum(in, out, all, where);
    }
    template <int items>
    void ExclusiveSum(const T (&in)[items], T (&out)[items], T& all, Where where = Where::here()) {
        T before;
        ExclusiveSum(sum_of(in), before, all, where);
        for (int i = 0; i < items; ++i) {
            const T value = in[i]; // `out` may be `in`
            out[i] = before;
            before = before + value;
        }
    }

  private:
    template <int items> static T sum_of(const T (&values)[items]) {
        T sum = values[0];
        for (int i = 1; i < items; ++i) sum = sum + values[i];
        return sum;
    }
    void bring(const char* operation, T value, Where where) {
        storage_.values[detail::thread_rank()] = value;
        detail::meet(operation, where);
    }
    template <class Combine> T up_to(int end, Combine combine) const {
        T result = storage_.values[0];
        for (int i = 1; i < end; ++i) result = combine(result, storage_.values[i]);
        return result;
    }

    TempStorage& storage_;
};

} // namespace cub
