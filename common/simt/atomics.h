// Atomic read-modify-write operations. Each returns the value that it found.
//
// CUDA's are relaxed and ordered by __threadfence(). Here each is acquire and release at once: on
// x86-64 that costs nothing, and ThreadSanitizer, which does not follow separate fences, then
// understands the usual "write, fence, count; the last one reads".
#pragma once

#include "common/simt/qualifiers.h"

#include <cstdint>
#include <type_traits>

#if defined(RAYLAB_CHECK_WATCH)
extern "C" void raylab_checks_again(const volatile void* place); // watch/watcher.h
#endif

namespace raylab::simt {

// The watch takes a plain read for harmless if an operation that announces itself here looks at the
// place again (watch/race_book.h).
inline void checks_again([[maybe_unused]] const volatile void* place) {
#if defined(RAYLAB_CHECK_WATCH)
    raylab_checks_again(place);
#endif
}

// Replaces *address by update(*address), trying again while other threads get in between.
template <class T, class Update> __forceinline__ T atomic_update(T* address, Update update) {
    T found, wanted;
    __atomic_load(address, &found, __ATOMIC_RELAXED);
    do {
        wanted = update(found);
    } while (!__atomic_compare_exchange(address, &found, &wanted, false, __ATOMIC_ACQ_REL,
                                        __ATOMIC_ACQUIRE));
    return found;
}

} // namespace raylab::simt

__forceinline__ int atomicAdd(int* p, int v) { return __atomic_fetch_add(p, v, __ATOMIC_ACQ_REL); }
__forceinline__ unsigned atomicAdd(unsigned* p, unsigned v) {
    return __atomic_fetch_add(p, v, __ATOMIC_ACQ_REL);
}
__forceinline__ unsigned long long atomicAdd(unsigned long long* p, unsigned long long v) {
    return __atomic_fetch_add(p, v, __ATOMIC_ACQ_REL);
}
__forceinline__ float atomicAdd(float* p, float v) {
    return raylab::simt::atomic_update(p, [v](float old) { return old + v; });
}
__forceinline__ double atomicAdd(double* p, double v) {
    return raylab::simt::atomic_update(p, [v](double old) { return old + v; });
}

__forceinline__ int atomicSub(int* p, int v) { return __atomic_fetch_sub(p, v, __ATOMIC_ACQ_REL); }
__forceinline__ unsigned atomicSub(unsigned* p, unsigned v) {
    return __atomic_fetch_sub(p, v, __ATOMIC_ACQ_REL);
}

__forceinline__ float atomicExch(float* p, float v) {
    float found;
    __atomic_exchange(p, &v, &found, __ATOMIC_ACQ_REL);
    return found;
}

// atomicInc counts 0, 1, ..., limit, 0, ...; atomicDec counts down, and restarts at the limit.
__forceinline__ unsigned atomicInc(unsigned* p, unsigned limit) {
    return raylab::simt::atomic_update(p, [=](unsigned old) { return old >= limit ? 0 : old + 1; });
}
__forceinline__ unsigned atomicDec(unsigned* p, unsigned limit) {
    return raylab::simt::atomic_update(
        p, [=](unsigned old) { return old == 0 || old > limit ? limit : old - 1; });
}

// The operations that CUDA gives for each integer type.
#define RAYLAB_ATOMICS(T)                                                                          \
    __forceinline__ T atomicExch(T* p, T v) {                                                      \
        return __atomic_exchange_n(p, v, __ATOMIC_ACQ_REL);                                        \
    }                                                                                              \
    __forceinline__ T atomicAnd(T* p, T v) { return __atomic_fetch_and(p, v, __ATOMIC_ACQ_REL); }  \
    __forceinline__ T atomicOr(T* p, T v) { return __atomic_fetch_or(p, v, __ATOMIC_ACQ_REL); }    \
    __forceinline__ T atomicXor(T* p, T v) { return __atomic_fetch_xor(p, v, __ATOMIC_ACQ_REL); }  \
    __forceinline__ T atomicCAS(T* p, T compare, T v) {                                            \
        raylab::simt::checks_again(p);                                                             \
        __atomic_compare_exchange_n(p, &compare, v, false, __ATOMIC_ACQ_REL, __ATOMIC_ACQUIRE);    \
        return compare;                                                                            \
    }                                                                                              \
    __forceinline__ T atomicMin(T* p, T v) {                                                       \
        raylab::simt::checks_again(p);                                                             \
        return raylab::simt::atomic_update(p, [v](T old) { return v < old ? v : old; });           \
    }                                                                                              \
    __forceinline__ T atomicMax(T* p, T v) {                                                       \
        raylab::simt::checks_again(p);                                                             \
        return raylab::simt::atomic_update(p, [v](T old) { return old < v ? v : old; });           \
    }

RAYLAB_ATOMICS(int)
RAYLAB_ATOMICS(unsigned)
RAYLAB_ATOMICS(unsigned long long)

#undef RAYLAB_ATOMICS

__forceinline__ long long atomicMin(long long* p, long long v) {
    raylab::simt::checks_again(p);
    return raylab::simt::atomic_update(p, [v](long long old) { return v < old ? v : old; });
}
__forceinline__ long long atomicMax(long long* p, long long v) {
    raylab::simt::checks_again(p);
    return raylab::simt::atomic_update(p, [v](long long old) { return old < v ? v : old; });
}

// Fences. ThreadSanitizer's build only keeps the compiler from moving accesses across (see above).
inline void __threadfence_block() { __atomic_signal_fence(__ATOMIC_SEQ_CST); }
inline void __threadfence() {
#if defined(RAYLAB_CHECK_THREAD)
    __atomic_signal_fence(__ATOMIC_SEQ_CST);
#else
    __atomic_thread_fence(__ATOMIC_SEQ_CST);
#endif
}
inline void __threadfence_system() { __threadfence(); }
