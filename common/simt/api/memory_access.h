// Loads and stores that name a cache, which are loads and stores; and atomics that name a scope.
#pragma once

#include "common/simt/atomics.h"
#include "common/simt/device_math.h"

template <class T> inline T __ldcg(const T* address) { return *address; }
template <class T> inline T __ldca(const T* address) { return *address; }
template <class T> inline T __ldcs(const T* address) { return *address; }
template <class T> inline T __ldlu(const T* address) { return *address; }
template <class T> inline T __ldcv(const T* address) { return *address; }
template <class T> inline void __stwb(T* address, std::type_identity_t<T> value) {
    *address = value;
}
template <class T> inline void __stcg(T* address, std::type_identity_t<T> value) {
    *address = value;
}
template <class T> inline void __stcs(T* address, std::type_identity_t<T> value) {
    *address = value;
}
template <class T> inline void __stwt(T* address, std::type_identity_t<T> value) {
    *address = value;
}

// The scope of a block or of the whole system: all atomics here hold for everybody.
#define RAYLAB_SCOPED(name)                                                                        \
    template <class T> inline T name##_block(T* address, std::type_identity_t<T> value) {          \
        return name(address, value);                                                               \
    }                                                                                              \
    template <class T> inline T name##_system(T* address, std::type_identity_t<T> value) {         \
        return name(address, value);                                                               \
    }

RAYLAB_SCOPED(atomicAdd)
RAYLAB_SCOPED(atomicSub)
RAYLAB_SCOPED(atomicExch)
RAYLAB_SCOPED(atomicMin)
RAYLAB_SCOPED(atomicMax)
RAYLAB_SCOPED(atomicInc)
RAYLAB_SCOPED(atomicDec)
RAYLAB_SCOPED(atomicAnd)
RAYLAB_SCOPED(atomicOr)
RAYLAB_SCOPED(atomicXor)

#undef RAYLAB_SCOPED

template <class T>
inline T atomicCAS_block(T* address, std::type_identity_t<T> compare,
                         std::type_identity_t<T> value) {
    return atomicCAS(address, compare, value);
}
template <class T>
inline T atomicCAS_system(T* address, std::type_identity_t<T> compare,
                          std::type_identity_t<T> value) {
    return atomicCAS(address, compare, value);
}
inline unsigned short atomicCAS(unsigned short* address, unsigned short compare,
                                unsigned short value) {
    raylab::simt::checks_again(address);
    __atomic_compare_exchange_n(address, &compare, value, false, __ATOMIC_ACQ_REL,
                                __ATOMIC_ACQUIRE);
    return compare;
}

// clang knows __builtin_assume, and g++ must be told in its own way.
#if !defined(__clang__)
#define __builtin_assume(condition)                                                                \
    do {                                                                                           \
        if (!(condition)) __builtin_unreachable();                                                 \
    } while (false)
#endif
#define __assume(condition) __builtin_assume(condition)
#define __brkpt() __trap()
