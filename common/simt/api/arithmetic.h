// Floating-point functions beyond device_math.h: arithmetic with a chosen rounding, and functions
// that <cmath> lacks.
//
// A result rounded towards zero, up or down is the nearest one, or its neighbour: the sign of what
// rounding left out, which is known exactly, tells which.
#pragma once

#include "common/simt/api/conversions.h"

namespace raylab::simt {

enum class Rounding { zero, up, down };

// `nearest`, whose exact value is `nearest + rest`.
template <Rounding rounding, class T> inline T directed(T nearest, T rest) {
    constexpr T infinity = std::numeric_limits<T>::infinity();
    if (!(rest < 0 || rest > 0) || !std::isfinite(nearest)) return nearest;
    bool up = rounding == Rounding::up ||
              (rounding == Rounding::zero && (nearest != 0 ? nearest < 0 : rest < 0));
    if (up && rest > 0) return std::nextafter(nearest, infinity);
    if (!up && rest < 0) return std::nextafter(nearest, -infinity);
    return nearest;
}

template <Rounding rounding, class T> inline T add(T a, T b) {
    T sum = a + b, b_part = sum - a, a_part = sum - b_part; // Knuth's exact sum
    return directed<rounding>(sum, (a - a_part) + (b - b_part));
}
template <Rounding rounding, class T> inline T multiply(T a, T b) {
    T product = a * b;
    return directed<rounding>(product, std::fma(a, b, -product));
}
template <Rounding rounding, class T> inline T divide(T a, T b) {
    T quotient = a / b, rest = std::fma(-quotient, b, a);
    return directed<rounding>(quotient, b < 0 ? -rest : rest);
}
template <Rounding rounding, class T> inline T root(T a) {
    T root = std::sqrt(a);
    return directed<rounding>(root, std::fma(-root, root, a));
}
// Products of floats are exact as doubles; what their sum leaves out only matters where the double
// is a float already.
template <Rounding rounding> inline float multiply_add(float a, float b, float c) {
    double product = double(a) * b, sum = product + c, c_part = sum - product;
    double left_out = (product - (sum - c_part)) + (c - c_part);
    float nearest = std::fma(a, b, c);
    double rest = sum - nearest;
    return directed<rounding>(nearest, float(rest != 0 ? rest : left_out));
}

inline constexpr double pi = 3.14159265358979323846;

// sin(pi x) and cos(pi x), exact where they are 0 and 1.
inline double sin_pi(double x) {
    double r = std::remainder(x, 2.0);
    if (r == 1 || r == -1 || r == 0) return std::copysign(0.0, x);
    return std::abs(r) > 0.5 ? std::sin(pi * std::copysign(1 - std::abs(r), r)) : std::sin(pi * r);
}
inline double cos_pi(double x) {
    double r = std::abs(std::remainder(x, 2.0));
    if (r == 0.5) return 0;
    return r > 0.5 ? -std::cos(pi * (1 - r)) : std::cos(pi * r);
}

} // namespace raylab::simt

#define RAYLAB_ROUNDED(suffix, rounding)                                                           \
    inline float __fadd_##suffix(float a, float b) { return raylab::simt::add<rounding>(a, b); }   \
    inline float __fsub_##suffix(float a, float b) { return raylab::simt::add<rounding>(a, -b); }  \
    inline float __fmul_##suffix(float a, float b) {                                               \
        return raylab::simt::multiply<rounding>(a, b);                                             \
    }                                                                                              \
    inline float __fdiv_##suffix(float a, float b) {                                               \
        return raylab::simt::divide<rounding>(a, b);                                               \
    }                                                                                              \
    inline float __frcp_##suffix(float a) { return raylab::simt::divide<rounding>(1.0f, a); }      \
    inline float __fsqrt_##suffix(float a) { return raylab::simt::root<rounding>(a); }             \
    inline float __fmaf_##suffix(float a, float b, float c) {                                      \
        return raylab::simt::multiply_add<rounding>(a, b, c);                                      \
    }                                                                                              \
    inline double __dadd_##suffix(double a, double b) {                                            \
        return raylab::simt::add<rounding>(a, b);                                                  \
    }                                                                                              \
    inline double __dsub_##suffix(double a, double b) {                                            \
        return raylab::simt::add<rounding>(a, -b);                                                 \
    }                                                                                              \
    inline double __dmul_##suffix(double a, double b) {                                            \
        return raylab::simt::multiply<rounding>(a, b);                                             \
    }                                                                                              \
    inline double __ddiv_##suffix(double a, double b) {                                            \
        return raylab::simt::divide<rounding>(a, b);                                               \
    }                                                                                              \
    inline double __drcp_##suffix(double a) { return raylab::simt::divide<rounding>(1.0, a); }     \
    inline double __dsqrt_##suffix(double a) { return raylab::simt::root<rounding>(a); }

RAYLAB_ROUNDED(rz, raylab::simt::Rounding::zero)
RAYLAB_ROUNDED(ru, raylab::simt::Rounding::up)
RAYLAB_ROUNDED(rd, raylab::simt::Rounding::down)

#undef RAYLAB_ROUNDED

inline double __dadd_rn(double a, double b) { return a + b; }
inline double __dsub_rn(double a, double b) { return a - b; }
inline double __dmul_rn(double a, double b) { return a * b; }
inline double __ddiv_rn(double a, double b) { return a / b; }
inline double __drcp_rn(double a) { return 1 / a; }
inline double __dsqrt_rn(double a) { return std::sqrt(a); }
inline double __fma_rn(double a, double b, double c) { return std::fma(a, b, c); }
inline float __frsqrt_rn(float a) { return float(1 / std::sqrt(double(a))); }

inline float fdividef(float a, float b) { return a / b; }
inline float __tanf(float x) { return std::tan(x); }
inline float __log2f(float x) { return std::log2(x); }
inline float __log10f(float x) { return std::log10(x); }
inline float __exp10f(float x) { return float(std::pow(10.0, double(x))); }
#if !defined(__APPLE__) // whose <math.h> has a function of this name that does the same
inline void __sincosf(float x, float* sine, float* cosine) {
    *sine = std::sin(x);
    *cosine = std::cos(x);
}
#endif

inline float sinpif(float x) { return float(raylab::simt::sin_pi(x)); }
inline float cospif(float x) { return float(raylab::simt::cos_pi(x)); }
inline double sinpi(double x) { return raylab::simt::sin_pi(x); }
inline double cospi(double x) { return raylab::simt::cos_pi(x); }
inline void sincospif(float x, float* sine, float* cosine) {
    *sine = sinpif(x);
    *cosine = cospif(x);
}
inline void sincospi(double x, double* sine, double* cosine) {
    *sine = sinpi(x);
    *cosine = cospi(x);
}
inline float rcbrtf(float x) { return float(1 / std::cbrt(double(x))); }
inline double rcbrt(double x) { return 1 / std::cbrt(x); }
inline float rhypotf(float x, float y) { return float(1 / std::hypot(double(x), double(y))); }
inline double rhypot(double x, double y) { return 1 / std::hypot(x, y); }
inline float norm3df(float x, float y, float z) { return std::hypot(x, y, z); }
inline double norm3d(double x, double y, double z) { return std::hypot(x, y, z); }
inline float rnorm3df(float x, float y, float z) { return 1 / std::hypot(x, y, z); }
inline double rnorm3d(double x, double y, double z) { return 1 / std::hypot(x, y, z); }
inline float norm4df(float x, float y, float z, float w) {
    return std::hypot(std::hypot(x, y), std::hypot(z, w));
}
inline double norm4d(double x, double y, double z, double w) {
    return std::hypot(std::hypot(x, y), std::hypot(z, w));
}
// The distribution function of the normal distribution.
inline float normcdff(float x) { return float(std::erfc(-double(x) * M_SQRT1_2) / 2); }
inline double normcdf(double x) { return std::erfc(-x * M_SQRT1_2) / 2; }

#if !defined(__GLIBC__) // whose <math.h> has them
inline float exp10f(float x) { return float(std::pow(10.0, double(x))); }
inline double exp10(double x) { return std::pow(10.0, x); }
inline void sincosf(float x, float* sine, float* cosine) { __sincosf(x, sine, cosine); }
inline void sincos(double x, double* sine, double* cosine) {
    *sine = std::sin(x);
    *cosine = std::cos(x);
}
#endif
