// bfloat16: the types, and the functions that have bfloat16 in their names.
#pragma once

#include "cuda_runtime.h"

#include "common/simt/small_float/functions.h"

using __nv_bfloat16 = raylab::simt::SmallFloat<raylab::simt::Format<8, 7>>;
using __nv_bfloat162 = raylab::simt::SmallFloat2<__nv_bfloat16>;
using nv_bfloat16 = __nv_bfloat16;
using nv_bfloat162 = __nv_bfloat162;

inline float __bfloat162float(__nv_bfloat16 a) { return float(a); }
inline __nv_bfloat16 __float2bfloat16(float a) { return a; }
inline __nv_bfloat16 __double2bfloat16(double a) { return a; }
#define RAYLAB_TO_BFLOAT16(suffix, round)                                                          \
    inline __nv_bfloat16 __float2bfloat16_##suffix(float a) {                                      \
        return __nv_bfloat16::from_bits(__nv_bfloat16::Bits::from(a, raylab::simt::Round::round)); \
    }                                                                                              \
    inline __nv_bfloat16 __int2bfloat16_##suffix(int a) {                                          \
        return __nv_bfloat16::from_bits(__nv_bfloat16::Bits::from(a, raylab::simt::Round::round)); \
    }                                                                                              \
    inline int __bfloat162int_##suffix(__nv_bfloat16 a) { return __float2int_##suffix(a); }        \
    inline unsigned __bfloat162uint_##suffix(__nv_bfloat16 a) { return __float2uint_##suffix(a); }
RAYLAB_TO_BFLOAT16(rn, nearest)
RAYLAB_TO_BFLOAT16(rz, zero)
RAYLAB_TO_BFLOAT16(ru, up)
RAYLAB_TO_BFLOAT16(rd, down)
#undef RAYLAB_TO_BFLOAT16

inline short __bfloat16_as_short(__nv_bfloat16 a) { return short(a.bits); }
inline unsigned short __bfloat16_as_ushort(__nv_bfloat16 a) { return a.bits; }
inline __nv_bfloat16 __short_as_bfloat16(short a) { return __nv_bfloat16::from_bits(unsigned(a)); }
inline __nv_bfloat16 __ushort_as_bfloat16(unsigned short a) { return __nv_bfloat16::from_bits(a); }

inline __nv_bfloat162 make_bfloat162(__nv_bfloat16 x, __nv_bfloat16 y) { return {x, y}; }
inline __nv_bfloat162 __halves2bfloat162(__nv_bfloat16 x, __nv_bfloat16 y) { return {x, y}; }
inline __nv_bfloat162 __bfloat162bfloat162(__nv_bfloat16 a) { return {a, a}; }
inline __nv_bfloat162 __float2bfloat162_rn(float a) { return {a, a}; }
inline __nv_bfloat162 __floats2bfloat162_rn(float x, float y) { return {x, y}; }
inline __nv_bfloat162 __float22bfloat162_rn(float2 a) { return {a.x, a.y}; }
inline float2 __bfloat1622float2(__nv_bfloat162 a) { return make_float2(a.x, a.y); }
inline __nv_bfloat16 __low2bfloat16(__nv_bfloat162 a) { return a.x; }
inline __nv_bfloat16 __high2bfloat16(__nv_bfloat162 a) { return a.y; }
