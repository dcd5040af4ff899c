// CUDA's complex numbers: vectors of two, real part first.
#pragma once

#include "cuda_runtime.h"

using cuFloatComplex = float2;
using cuDoubleComplex = double2;
using cuComplex = cuFloatComplex;

inline cuFloatComplex make_cuFloatComplex(float x, float y) { return {x, y}; }
inline cuDoubleComplex make_cuDoubleComplex(double x, double y) { return {x, y}; }
inline cuComplex make_cuComplex(float x, float y) { return {x, y}; }

namespace raylab::simt {

// Products and quotients as in C, without its care for infinities.
template <class Complex> inline Complex product(Complex a, Complex b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
// Scaled by the size of b, so that its square does not overflow.
template <class Complex> inline Complex quotient(Complex a, Complex b) {
    auto scale = 1 / (std::abs(b.x) + std::abs(b.y));
    a = {a.x * scale, a.y * scale};
    b = {b.x * scale, b.y * scale};
    auto square = 1 / (b.x * b.x + b.y * b.y);
    return {(a.x * b.x + a.y * b.y) * square, (a.y * b.x - a.x * b.y) * square};
}

} // namespace raylab::simt

#define RAYLAB_COMPLEX(Real, Complex, suffix)                                                      \
    inline Real cuCreal##suffix(Complex a) { return a.x; }                                         \
    inline Real cuCimag##suffix(Complex a) { return a.y; }                                         \
    inline Real cuCabs##suffix(Complex a) { return std::hypot(a.x, a.y); }                         \
    inline Complex cuConj##suffix(Complex a) { return {a.x, -a.y}; }                               \
    inline Complex cuCadd##suffix(Complex a, Complex b) { return {a.x + b.x, a.y + b.y}; }         \
    inline Complex cuCsub##suffix(Complex a, Complex b) { return {a.x - b.x, a.y - b.y}; }         \
    inline Complex cuCmul##suffix(Complex a, Complex b) { return raylab::simt::product(a, b); }    \
    inline Complex cuCdiv##suffix(Complex a, Complex b) { return raylab::simt::quotient(a, b); }   \
    inline Complex cuCfma##suffix(Complex a, Complex b, Complex c) {                               \
        return cuCadd##suffix(raylab::simt::product(a, b), c);                                     \
    }

RAYLAB_COMPLEX(float, cuFloatComplex, f)
RAYLAB_COMPLEX(double, cuDoubleComplex, )

#undef RAYLAB_COMPLEX

inline cuDoubleComplex cuComplexFloatToDouble(cuFloatComplex a) { return {a.x, a.y}; }
inline cuFloatComplex cuComplexDoubleToFloat(cuDoubleComplex a) { return {float(a.x), float(a.y)}; }
