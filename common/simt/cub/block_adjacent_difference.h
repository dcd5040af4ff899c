// cub::BlockAdjacentDifference: each value of a block combined with its neighbour, several values a
// thread, those of thread 0 first. The value without a neighbour stays as it is.
#pragma once

#include "common/simt/cub/operators.h"

namespace cub {

template <class T, int X, int Y = 1, int Z = 1, int = 0> class BlockAdjacentDifference {
    static constexpr int threads = X * Y * Z;
    using Where = detail::Where;

  public:
    struct TempStorage {
        T first[threads], last[threads]; // values of each thread
    };

    explicit BlockAdjacentDifference(TempStorage& storage) : storage_(storage) {}

    // out[i] = difference(in[i], in[i - 1])
    template <int items, class Out, class Combine>
    void SubtractLeft(T (&in)[items], Out (&out)[items], Combine difference,
                      Where where = Where::here()) {
        const int rank = bring("BlockAdjacentDifference::SubtractLeft()", in, where);
        subtract_left(in, out, difference, rank > 0 ? &storage_.last[rank - 1] : nullptr);
    }
    // `before`: the left neighbour of the block's first value.
    template <int items, class Out, class Combine>
    void SubtractLeft(T (&in)[items], Out (&out)[items], Combine difference, T before,
                      Where where = Where::here()) {
        const int rank = bring("BlockAdjacentDifference::SubtractLeft()", in, where);
        subtract_left(in, out, difference, rank > 0 ? &storage_.last[rank - 1] : &before);
    }
    // out[i] = difference(in[i], in[i + 1])
    template <int items, class Out, class Combine>
    void SubtractRight(T (&in)[items], Out (&out)[items], Combine difference,
                       Where where = Where::here()) {
        const int rank = bring("BlockAdjacentDifference::SubtractRight()", in, where);
        for (int i = 0; i + 1 < items; ++i) out[i] = difference(in[i], in[i + 1]);
        out[items - 1] = rank + 1 < threads
                             ? Out(difference(in[items - 1], storage_.first[rank + 1]))
                             : Out(in[items - 1]);
    }

  private:
    template <int items> int bring(const char* operation, T (&in)[items], Where where) {
        const int rank = detail::thread_rank();
        storage_.first[rank] = in[0];
        storage_.last[rank] = in[items - 1];
        detail::meet(operation, where);
        return rank;
    }
    // From the last to the first, since `out` may be `in`.
    template <int items, class Out, class Combine>
    static void subtract_left(T (&in)[items], Out (&out)[items], Combine difference, T* before) {
        for (int i = items - 1; i > 0; --i) out[i] = difference(in[i], in[i - 1]);
        out[0] = before ? Out(difference(in[0], *before)) : Out(in[0]);
    }

    TempStorage& storage_;
};

} // namespace cub
