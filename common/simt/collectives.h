// What threads do together: barriers of a block, and shuffles, votes and barriers of a warp.
//
// CUDA's names are macros here, so that each knows its place in the source (site.h). The functions
// below wait until every thread concerned has come to the same place (engine/block.h); a thread
// that can never come is a fault, reported with everybody's file and line (engine/report.h).
#pragma once

#include "common/simt/index.h"
#include "common/simt/site.h"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace raylab::simt {

// Waits for all threads of the block. Returns in how many of them `predicate` was not 0.
int sync_block(const Site& site, int predicate);

// Waits for the lanes in `mask`.
void sync_warp(const Site& site, unsigned mask = 0xffffffffu);

// Waits for the lanes in `mask`. Returns the set of lanes whose `predicate` is not 0.
unsigned vote(const Site& site, unsigned mask, int predicate);

// Waits for the lanes in `mask`. Returns the value that lane `source` brought; all bits set if that
// lane brought none (CUDA leaves it undefined), which as a float is a NaN.
uint64_t shuffle(const Site& site, unsigned mask, uint64_t value, int source);

// Waits for the lanes in `mask`. Fills all[0..31] with the values that they brought.
void gather(const Site& site, unsigned mask, uint64_t value, uint64_t* all);

// The lanes that are at this very place together: all that can come here before they must wait.
unsigned active_mask(const Site& site);

// Reports "a kernel called __trap()" and ends the launch.
[[noreturn]] void trap(const Site& site);

// The caller's lane in its warp; threads are numbered x first, then y, then z.
inline int lane_index() {
    return int((threadIdx.z * blockDim.y + threadIdx.y) * blockDim.x + threadIdx.x) % warpSize;
}

// As where CUDA's overloads choose: bool, char and short become int.
template <class T, bool promoted = std::is_integral_v<T> && (sizeof(T) < 4)> struct ShuffledType {
    using Type = T;
};
template <class T> struct ShuffledType<T, true> { using Type = int; };
template <class T> using Shuffled = typename ShuffledType<T>::Type;

template <class T> inline T shuffle_value(const Site& site, unsigned mask, T value, int source) {
    static_assert(sizeof(T) <= 8, "shuffles move values of at most 64 bits");
    uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(T));
    bits = shuffle(site, mask, bits, source);
    std::memcpy(&value, &bits, sizeof(T));
    return value;
}

// A warp is cut into segments of `width` lanes, a power of two. A source outside of the segment
// means the lane itself, except that the plain shuffle wraps around.
template <class T>
inline Shuffled<T> shfl(const Site& site, unsigned mask, T value, int source,
                        int width = warpSize) {
    int first = lane_index() & ~(width - 1);
    return shuffle_value<Shuffled<T>>(site, mask, value, first + (source & (width - 1)));
}
template <class T>
inline Shuffled<T> shfl_up(const Site& site, unsigned mask, T value, unsigned delta,
                           int width = warpSize) {
    int lane = lane_index(), first = lane & ~(width - 1), source = lane - int(delta);
    return shuffle_value<Shuffled<T>>(site, mask, value, source >= first ? source : lane);
}
template <class T>
inline Shuffled<T> shfl_down(const Site& site, unsigned mask, T value, unsigned delta,
                             int width = warpSize) {
    int lane = lane_index(), last = lane | (width - 1), source = lane + int(delta);
    return shuffle_value<Shuffled<T>>(site, mask, value, source <= last ? source : lane);
}
// The partner may be in a lower segment, but not in a higher one.
template <class T>
inline Shuffled<T> shfl_xor(const Site& site, unsigned mask, T value, int bits,
                            int width = warpSize) {
    int lane = lane_index(), last = lane | (width - 1), source = lane ^ bits;
    return shuffle_value<Shuffled<T>>(site, mask, value, source <= last ? source : lane);
}

} // namespace raylab::simt

#define __syncthreads() ((void)::raylab::simt::sync_block(RAYLAB_SITE("__syncthreads()"), 0))
#define __syncthreads_count(predicate)                                                             \
    ::raylab::simt::sync_block(RAYLAB_SITE("__syncthreads_count()"), (predicate) != 0)
#define __syncthreads_or(predicate)                                                                \
    (::raylab::simt::sync_block(RAYLAB_SITE("__syncthreads_or()"), (predicate) != 0) > 0)
#define __syncthreads_and(predicate)                                                               \
    (::raylab::simt::sync_block(RAYLAB_SITE("__syncthreads_and()"), (predicate) == 0) == 0)

#define __syncwarp(...)                                                                            \
    ::raylab::simt::sync_warp(RAYLAB_SITE("__syncwarp()") __VA_OPT__(, ) __VA_ARGS__)
#define __shfl_sync(...) ::raylab::simt::shfl(RAYLAB_SITE("__shfl_sync()"), __VA_ARGS__)
#define __shfl_up_sync(...) ::raylab::simt::shfl_up(RAYLAB_SITE("__shfl_up_sync()"), __VA_ARGS__)
#define __shfl_down_sync(...)                                                                      \
    ::raylab::simt::shfl_down(RAYLAB_SITE("__shfl_down_sync()"), __VA_ARGS__)
#define __shfl_xor_sync(...) ::raylab::simt::shfl_xor(RAYLAB_SITE("__shfl_xor_sync()"), __VA_ARGS__)

#define __ballot_sync(mask, predicate)                                                             \
    ::raylab::simt::vote(RAYLAB_SITE("__ballot_sync()"), mask, (predicate) != 0)
#define __any_sync(mask, predicate)                                                                \
    (::raylab::simt::vote(RAYLAB_SITE("__any_sync()"), mask, (predicate) != 0) != 0)
#define __all_sync(mask, predicate)                                                                \
    (::raylab::simt::vote(RAYLAB_SITE("__all_sync()"), mask, (predicate) == 0) == 0)
#define __activemask() ::raylab::simt::active_mask(RAYLAB_SITE("__activemask()"))
#define __trap() ::raylab::simt::trap(RAYLAB_SITE("__trap()"))
