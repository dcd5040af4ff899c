// cub::BlockReduce: the values of a block's threads combined, from the first to the last.
//
// Only thread 0 gets the result, as CUB promises; others get what they brought. Sums of floats
// differ in their last bits from a GPU's, which adds in another order.
#pragma once

#include "common/simt/cub/operators.h"

namespace cub {

enum BlockReduceAlgorithm { // all the same here
    BLOCK_REDUCE_RAKING_COMMUTATIVE_ONLY,
    BLOCK_REDUCE_RAKING,
    BLOCK_REDUCE_WARP_REDUCTIONS
};

template <class T, int X, BlockReduceAlgorithm = BLOCK_REDUCE_WARP_REDUCTIONS, int Y = 1, int Z = 1,
          int = 0>
class BlockReduce {
    static constexpr int threads = X * Y * Z;
    using Where = detail::Where;

  public:
    using TempStorage = detail::ValuesOfThreads<T, threads>;

    explicit BlockReduce(TempStorage& storage) : storage_(storage) {}

    // Of the first `valid` threads.
    template <class Combine>
    T Reduce(T value, Combine combine, int valid, Where where = Where::here()) {
        return reduce("BlockReduce::Reduce()", value, combine, valid, where);
    }
    template <class Combine> T Reduce(T value, Combine combine, Where where = Where::here()) {
        return reduce("BlockReduce::Reduce()", value, combine, threads, where);
    }
    template <int items, class Combine>
    T Reduce(const T (&values)[items], Combine combine, Where where = Where::here()) {
        return reduce("BlockReduce::Reduce()", of_items(values, combine), combine, threads, where);
    }
    T Sum(T value, int valid, Where where = Where::here()) {
        return reduce("BlockReduce::Sum()", value, cub::Sum(), valid, where);
    }
    T Sum(T value, Where where = Where::here()) {
        return reduce("BlockReduce::Sum()", value, cub::Sum(), threads, where);
    }
    template <int items> T Sum(const T (&values)[items], Where where = Where::here()) {
        return reduce("BlockReduce::Sum()", of_items(values, cub::Sum()), cub::Sum(), threads,
                      where);
    }

  private:
    template <int items, class Combine>
    static T of_items(const T (&values)[items], Combine combine) {
        T result = values[0];
        for (int i = 1; i < items; ++i) result = combine(result, values[i]);
        return result;
    }

    template <class Combine>
    T reduce(const char* operation, T value, Combine combine, int valid, Where where) {
        const int rank = detail::thread_rank();
        storage_.values[rank] = value;
        detail::meet(operation, where);
        if (rank != 0) return value;
        for (int i = 1; i < valid; ++i) value = combine(value, storage_.values[i]);
        return value;
    }

    TempStorage& storage_;
};

} // namespace cub
