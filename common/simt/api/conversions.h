// Conversions between numbers with a chosen rounding. As on a GPU, what is out of range becomes the
// nearest number that is in it, and NaN becomes 0.
#pragma once

#include "common/simt/device_math.h"

#include <limits>

namespace raylab::simt {

template <class To, class From> inline To to_integer(From value) {
    if (value != value) return 0;
    constexpr From end = From(1) * (To(1) << (sizeof(To) * 8 - 2)) * // the first power of two that
                         (std::numeric_limits<To>::is_signed ? 2 : 4); // is too large
    if (value >= end) return std::numeric_limits<To>::max();
    if (value <= From(std::numeric_limits<To>::min())) return std::numeric_limits<To>::min();
    return To(value);
}

// `exact` rounded to float in direction `up` (1), `down` (-1) or to zero (0).
inline float round_double(double exact, int direction) {
    float nearest = float(exact);
    if (direction == 0) direction = exact > 0 ? -1 : 1;
    if (direction < 0 && double(nearest) > exact) return std::nextafter(nearest, -INFINITY);
    if (direction > 0 && double(nearest) < exact) return std::nextafter(nearest, INFINITY);
    return nearest;
}

} // namespace raylab::simt

#define RAYLAB_TO_INTEGER(From, from, To, to)                                                      \
    inline To __##from##2##to##_rn(From x) {                                                       \
        return raylab::simt::to_integer<To>(std::nearbyint(x));                                    \
    }                                                                                              \
    inline To __##from##2##to##_rz(From x) { return raylab::simt::to_integer<To>(std::trunc(x)); } \
    inline To __##from##2##to##_ru(From x) { return raylab::simt::to_integer<To>(std::ceil(x)); }  \
    inline To __##from##2##to##_rd(From x) { return raylab::simt::to_integer<To>(std::floor(x)); }

RAYLAB_TO_INTEGER(float, float, int, int)
RAYLAB_TO_INTEGER(float, float, unsigned, uint)
RAYLAB_TO_INTEGER(float, float, long long, ll)
RAYLAB_TO_INTEGER(float, float, unsigned long long, ull)
RAYLAB_TO_INTEGER(double, double, int, int)
RAYLAB_TO_INTEGER(double, double, unsigned, uint)
RAYLAB_TO_INTEGER(double, double, long long, ll)
RAYLAB_TO_INTEGER(double, double, unsigned long long, ull)

#undef RAYLAB_TO_INTEGER

inline float __int2float_rn(int x) { return float(x); }
inline float __int2float_rz(int x) { return raylab::simt::round_double(x, 0); }
inline float __int2float_ru(int x) { return raylab::simt::round_double(x, 1); }
inline float __int2float_rd(int x) { return raylab::simt::round_double(x, -1); }
inline float __uint2float_rn(unsigned x) { return float(x); }
inline float __uint2float_rz(unsigned x) { return raylab::simt::round_double(x, 0); }
inline float __uint2float_ru(unsigned x) { return raylab::simt::round_double(x, 1); }
inline float __uint2float_rd(unsigned x) { return raylab::simt::round_double(x, -1); }
inline float __ll2float_rn(long long x) { return float(x); }
inline float __ull2float_rn(unsigned long long x) { return float(x); }
inline double __int2double_rn(int x) { return x; }
inline double __uint2double_rn(unsigned x) { return x; }
inline double __ll2double_rn(long long x) { return double(x); }
inline double __ull2double_rn(unsigned long long x) { return double(x); }

inline float __double2float_rn(double x) { return float(x); }
inline float __double2float_rz(double x) { return raylab::simt::round_double(x, 0); }
inline float __double2float_ru(double x) { return raylab::simt::round_double(x, 1); }
inline float __double2float_rd(double x) { return raylab::simt::round_double(x, -1); }

// The two halves of a double.
inline int __double2hiint(double x) { return int(std::bit_cast<uint64_t>(x) >> 32); }
inline int __double2loint(double x) { return int(std::bit_cast<uint64_t>(x)); }
inline double __hiloint2double(int high, int low) {
    return std::bit_cast<double>(uint64_t(unsigned(high)) << 32 | unsigned(low));
}
