// Half precision: the types, and the functions that have half in their names.
#pragma once

#include "cuda_runtime.h"

#include "common/simt/small_float/functions.h"

using __half = raylab::simt::SmallFloat<raylab::simt::Format<5, 10>>;
using __half2 = raylab::simt::SmallFloat2<__half>;
using half = __half;
using half2 = __half2;
struct __half_raw {
    unsigned short x;
};

inline float __half2float(__half a) { return float(a); }
inline __half __float2half(float a) { return a; }
inline __half __double2half(double a) { return a; }
#define RAYLAB_TO_HALF(suffix, round)                                                              \
    inline __half __float2half_##suffix(float a) {                                                 \
        return __half::from_bits(__half::Bits::from(a, raylab::simt::Round::round));               \
    }                                                                                              \
    inline __half __int2half_##suffix(int a) {                                                     \
        return __half::from_bits(__half::Bits::from(a, raylab::simt::Round::round));               \
    }                                                                                              \
    inline __half __uint2half_##suffix(unsigned a) {                                               \
        return __half::from_bits(__half::Bits::from(a, raylab::simt::Round::round));               \
    }                                                                                              \
    inline __half __short2half_##suffix(short a) { return __int2half_##suffix(a); }                \
    inline __half __ushort2half_##suffix(unsigned short a) { return __int2half_##suffix(a); }      \
    inline int __half2int_##suffix(__half a) { return __float2int_##suffix(a); }                   \
    inline unsigned __half2uint_##suffix(__half a) { return __float2uint_##suffix(a); }            \
    inline long long __half2ll_##suffix(__half a) { return __float2ll_##suffix(a); }               \
    inline short __half2short_##suffix(__half a) {                                                 \
        return short(min(max(__float2int_##suffix(a), -32768), 32767));                            \
    }                                                                                              \
    inline unsigned short __half2ushort_##suffix(__half a) {                                       \
        return (unsigned short)min(__float2uint_##suffix(a), 65535u);                              \
    }
RAYLAB_TO_HALF(rn, nearest)
RAYLAB_TO_HALF(rz, zero)
RAYLAB_TO_HALF(ru, up)
RAYLAB_TO_HALF(rd, down)
#undef RAYLAB_TO_HALF

inline short __half_as_short(__half a) { return short(a.bits); }
inline unsigned short __half_as_ushort(__half a) { return a.bits; }
inline __half __short_as_half(short a) { return __half::from_bits(unsigned(a)); }
inline __half __ushort_as_half(unsigned short a) { return __half::from_bits(a); }

inline __half2 make_half2(__half x, __half y) { return {x, y}; }
inline __half2 __halves2half2(__half x, __half y) { return {x, y}; }
inline __half2 __half2half2(__half a) { return {a, a}; }
inline __half2 __float2half2_rn(float a) { return {a, a}; }
inline __half2 __floats2half2_rn(float x, float y) { return {x, y}; }
inline __half2 __float22half2_rn(float2 a) { return {a.x, a.y}; }
inline float2 __half22float2(__half2 a) { return make_float2(a.x, a.y); }
inline __half __low2half(__half2 a) { return a.x; }
inline __half __high2half(__half2 a) { return a.y; }
