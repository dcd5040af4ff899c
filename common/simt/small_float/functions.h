// CUDA's functions of half and bfloat16 that have one name for both. Names with 2 take pairs.
#pragma once

#include "common/simt/small_float/small_float.h"

#define RAYLAB_SMALL template <raylab::simt::Small H> inline
#define RAYLAB_PAIR template <raylab::simt::SmallPair P> inline

// name(a, b) and name2(pair, pair)
#define RAYLAB_SMALL_BINARY(name, expression)                                                      \
    RAYLAB_SMALL H name(H a, H b) { return expression; }                                           \
    RAYLAB_PAIR P name##2(P p, P q) {                                                              \
        using H = typename P::Element;                                                             \
        return raylab::simt::for_both([](H a, H b) -> H { return expression; }, p, q);             \
    }

RAYLAB_SMALL_BINARY(__hadd, a + b)
RAYLAB_SMALL_BINARY(__hsub, a - b)
RAYLAB_SMALL_BINARY(__hmul, a* b)
RAYLAB_SMALL_BINARY(__hadd_rn, a + b)
RAYLAB_SMALL_BINARY(__hsub_rn, a - b)
RAYLAB_SMALL_BINARY(__hmul_rn, a* b)
RAYLAB_SMALL_BINARY(__hadd_sat, raylab::simt::clamp01(a + b))
RAYLAB_SMALL_BINARY(__hsub_sat, raylab::simt::clamp01(a - b))
RAYLAB_SMALL_BINARY(__hmul_sat, raylab::simt::clamp01(a* b))
RAYLAB_SMALL_BINARY(__hmax, a != a ? b : (b != b || a > b) ? a : b)
RAYLAB_SMALL_BINARY(__hmin, a != a ? b : (b != b || a < b) ? a : b)
RAYLAB_SMALL H __hdiv(H a, H b) { return a / b; }
RAYLAB_PAIR P __h2div(P a, P b) { return a / b; }

RAYLAB_SMALL H __hfma(H a, H b, H c) { return raylab::simt::fused(a, b, c); }
RAYLAB_SMALL H __hfma_sat(H a, H b, H c) {
    return raylab::simt::clamp01(raylab::simt::fused(a, b, c));
}
RAYLAB_SMALL H __hfma_relu(H a, H b, H c) { return __hmax(raylab::simt::fused(a, b, c), H(0)); }
RAYLAB_PAIR P __hfma2(P a, P b, P c) {
    return raylab::simt::for_both([](auto a, auto b, auto c) { return __hfma(a, b, c); }, a, b, c);
}

// Comparisons: of pairs 1 or 0 in each half, or with b one answer for both.
#define RAYLAB_SMALL_COMPARISON(name, operation)                                                   \
    RAYLAB_SMALL bool __h##name(H a, H b) { return a operation b; }                                \
    RAYLAB_PAIR P __h##name##2(P p, P q) {                                                         \
        using H = typename P::Element;                                                             \
        return raylab::simt::for_both([](H a, H b) { return H(a operation b ? 1 : 0); }, p, q);    \
    }                                                                                              \
    RAYLAB_PAIR bool __hb##name##2(P p, P q) { return p.x operation q.x && p.y operation q.y; }

RAYLAB_SMALL_COMPARISON(eq, ==)
RAYLAB_SMALL_COMPARISON(ne, !=)
RAYLAB_SMALL_COMPARISON(lt, <)
RAYLAB_SMALL_COMPARISON(le, <=)
RAYLAB_SMALL_COMPARISON(gt, >)
RAYLAB_SMALL_COMPARISON(ge, >=)

RAYLAB_SMALL bool __hisnan(H a) { return a != a; }
RAYLAB_SMALL int __hisinf(H a) { return std::isinf(float(a)) ? (a > H(0) ? 1 : -1) : 0; }

// name(a) for a number and name2(pair)
#define RAYLAB_SMALL_UNARY(name, pair_name, expression)                                            \
    RAYLAB_SMALL H name(H a) { return H(expression); }                                             \
    RAYLAB_PAIR P pair_name(P p) {                                                                 \
        return raylab::simt::for_both([](auto a) { return name(a); }, p);                          \
    }

RAYLAB_SMALL_UNARY(__hneg, __hneg2, -a)
RAYLAB_SMALL_UNARY(__habs, __habs2, H::from_bits(a.bits & 0x7fffu))
RAYLAB_SMALL_UNARY(hsqrt, h2sqrt, std::sqrt(float(a)))
RAYLAB_SMALL_UNARY(hrsqrt, h2rsqrt, 1 / std::sqrt(double(float(a))))
RAYLAB_SMALL_UNARY(hrcp, h2rcp, 1 / float(a))
RAYLAB_SMALL_UNARY(hexp, h2exp, std::exp(double(float(a))))
RAYLAB_SMALL_UNARY(hexp2, h2exp2, std::exp2(double(float(a))))
RAYLAB_SMALL_UNARY(hexp10, h2exp10, std::pow(10.0, double(float(a))))
RAYLAB_SMALL_UNARY(hlog, h2log, std::log(double(float(a))))
RAYLAB_SMALL_UNARY(hlog2, h2log2, std::log2(double(float(a))))
RAYLAB_SMALL_UNARY(hlog10, h2log10, std::log10(double(float(a))))
RAYLAB_SMALL_UNARY(hsin, h2sin, std::sin(double(float(a))))
RAYLAB_SMALL_UNARY(hcos, h2cos, std::cos(double(float(a))))
RAYLAB_SMALL_UNARY(htanh, h2tanh, std::tanh(double(float(a))))
RAYLAB_SMALL_UNARY(hfloor, h2floor, std::floor(float(a)))
RAYLAB_SMALL_UNARY(hceil, h2ceil, std::ceil(float(a)))
RAYLAB_SMALL_UNARY(htrunc, h2trunc, std::trunc(float(a)))
RAYLAB_SMALL_UNARY(hrint, h2rint, std::nearbyint(float(a)))

// Parts of pairs.
RAYLAB_PAIR auto __low2float(P p) { return float(p.x); }
RAYLAB_PAIR auto __high2float(P p) { return float(p.y); }
RAYLAB_PAIR P __lowhigh2highlow(P p) { return {p.y, p.x}; }
RAYLAB_PAIR P __low2half2(P p) { return {p.x, p.x}; }
RAYLAB_PAIR P __high2half2(P p) { return {p.y, p.y}; }
RAYLAB_PAIR P __lows2half2(P a, P b) { return {a.x, b.x}; }
RAYLAB_PAIR P __highs2half2(P a, P b) { return {a.y, b.y}; }

// The atomic add of each.
RAYLAB_SMALL H atomicAdd(H* address, std::type_identity_t<H> value) {
    return raylab::simt::atomic_update(address, [=](H old) { return old + value; });
}
RAYLAB_PAIR P atomicAdd(P* address, std::type_identity_t<P> value) {
    return raylab::simt::atomic_update(address, [=](P old) { return old + value; });
}

#undef RAYLAB_SMALL_BINARY
#undef RAYLAB_SMALL_COMPARISON
#undef RAYLAB_SMALL_UNARY
#undef RAYLAB_SMALL
#undef RAYLAB_PAIR
