// What lanes of a warp find out about each other's values: match and reduce; and the shuffles and
// votes of CUDA 8, which had no mask.
#pragma once

#include "common/simt/collectives.h"

#include <algorithm>
#include <bit>

namespace raylab::simt {

// The lanes of the caller's warp that the block has threads for.
inline unsigned existing_lanes() {
    unsigned thread = (threadIdx.z * blockDim.y + threadIdx.y) * blockDim.x + threadIdx.x;
    unsigned left = blockDim.x * blockDim.y * blockDim.z - thread / 32 * 32;
    return left >= 32 ? ~0u : (1u << left) - 1;
}

// Combines the values of the lanes in `mask`, lowest lane first.
template <class T, class Combine>
inline T reduce(const Site& site, unsigned mask, T value, Combine combine) {
    static_assert(sizeof(T) <= 8);
    uint64_t bits = 0, all[32];
    std::memcpy(&bits, &value, sizeof(T));
    gather(site, mask, bits, all);
    bool first = true;
    for (unsigned rest = mask & existing_lanes(); rest; rest &= rest - 1) {
        T other;
        std::memcpy(&other, &all[std::countr_zero(rest)], sizeof(T));
        value = first ? other : combine(value, other);
        first = false;
    }
    return value;
}

// The lanes whose value has the caller's bits.
template <class T> inline unsigned match_any(const Site& site, unsigned mask, T value) {
    static_assert(sizeof(T) <= 8);
    uint64_t bits = 0, all[32];
    std::memcpy(&bits, &value, sizeof(T));
    gather(site, mask, bits, all);
    unsigned same = 0;
    for (unsigned rest = mask & existing_lanes(); rest; rest &= rest - 1)
        if (all[std::countr_zero(rest)] == bits) same |= rest & -rest;
    return same;
}

// The mask if all of its lanes have the same value, else 0.
template <class T> inline unsigned match_all(const Site& site, unsigned mask, T value, int* equal) {
    *equal = match_any(site, mask, value) == (mask & existing_lanes());
    return *equal ? mask : 0;
}

template <class T> inline T reduce_add(const Site& site, unsigned mask, T value) {
    return reduce(site, mask, value, [](T a, T b) {
        return T(std::make_unsigned_t<T>(a) + std::make_unsigned_t<T>(b)); // wraps around
    });
}
template <class T> inline T reduce_min(const Site& site, unsigned mask, T value) {
    return reduce(site, mask, value, [](T a, T b) { return std::min(a, b); });
}
template <class T> inline T reduce_max(const Site& site, unsigned mask, T value) {
    return reduce(site, mask, value, [](T a, T b) { return std::max(a, b); });
}
inline unsigned reduce_and(const Site& site, unsigned mask, unsigned value) {
    return reduce(site, mask, value, [](unsigned a, unsigned b) { return a & b; });
}
inline unsigned reduce_or(const Site& site, unsigned mask, unsigned value) {
    return reduce(site, mask, value, [](unsigned a, unsigned b) { return a | b; });
}
inline unsigned reduce_xor(const Site& site, unsigned mask, unsigned value) {
    return reduce(site, mask, value, [](unsigned a, unsigned b) { return a ^ b; });
}

} // namespace raylab::simt

#define __match_any_sync(...)                                                                      \
    ::raylab::simt::match_any(RAYLAB_SITE("__match_any_sync()"), __VA_ARGS__)
#define __match_all_sync(...)                                                                      \
    ::raylab::simt::match_all(RAYLAB_SITE("__match_all_sync()"), __VA_ARGS__)
#define __reduce_add_sync(...)                                                                     \
    ::raylab::simt::reduce_add(RAYLAB_SITE("__reduce_add_sync()"), __VA_ARGS__)
#define __reduce_min_sync(...)                                                                     \
    ::raylab::simt::reduce_min(RAYLAB_SITE("__reduce_min_sync()"), __VA_ARGS__)
#define __reduce_max_sync(...)                                                                     \
    ::raylab::simt::reduce_max(RAYLAB_SITE("__reduce_max_sync()"), __VA_ARGS__)
#define __reduce_and_sync(...)                                                                     \
    ::raylab::simt::reduce_and(RAYLAB_SITE("__reduce_and_sync()"), __VA_ARGS__)
#define __reduce_or_sync(...)                                                                      \
    ::raylab::simt::reduce_or(RAYLAB_SITE("__reduce_or_sync()"), __VA_ARGS__)
#define __reduce_xor_sync(...)                                                                     \
    ::raylab::simt::reduce_xor(RAYLAB_SITE("__reduce_xor_sync()"), __VA_ARGS__)

// CUDA 8: those lanes take part that are at this place together.
#define RAYLAB_ACTIVE(name) ::raylab::simt::active_mask(RAYLAB_SITE(name))
#define __shfl(...)                                                                                \
    ::raylab::simt::shfl(RAYLAB_SITE("__shfl()"), RAYLAB_ACTIVE("__shfl()"), __VA_ARGS__)
#define __shfl_up(...)                                                                             \
    ::raylab::simt::shfl_up(RAYLAB_SITE("__shfl_up()"), RAYLAB_ACTIVE("__shfl_up()"), __VA_ARGS__)
#define __shfl_down(...)                                                                           \
    ::raylab::simt::shfl_down(RAYLAB_SITE("__shfl_down()"), RAYLAB_ACTIVE("__shfl_down()"),        \
                              __VA_ARGS__)
#define __shfl_xor(...)                                                                            \
    ::raylab::simt::shfl_xor(RAYLAB_SITE("__shfl_xor()"), RAYLAB_ACTIVE("__shfl_xor()"),           \
                             __VA_ARGS__)
#define __ballot(predicate) __ballot_sync(RAYLAB_ACTIVE("__ballot()"), predicate)
#define __any(predicate) __any_sync(RAYLAB_ACTIVE("__any()"), predicate)
#define __all(predicate) __all_sync(RAYLAB_ACTIVE("__all()"), predicate)

// Sleeping lets the other threads of the block go first.
#define __nanosleep(nanoseconds) ((void)(nanoseconds), (void)RAYLAB_ACTIVE("__nanosleep()"))
