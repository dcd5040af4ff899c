// CUDA's integer intrinsics beyond device_math.h, each as the programming guide defines it.
#pragma once

#include "common/simt/device_math.h"

// Products of the low 24 bits, and the upper half of a signed 64-bit product.
inline int __mul24(int a, int b) {
    return int((int64_t(a) << 40 >> 40) * (int64_t(b) << 40 >> 40));
}
inline unsigned __umul24(unsigned a, unsigned b) {
    return unsigned(uint64_t(a & 0xffffff) * (b & 0xffffff));
}
inline int mul24(int a, int b) { return __mul24(a, b); }
inline unsigned umul24(unsigned a, unsigned b) { return __umul24(a, b); }
inline int mulhi(int a, int b) { return __mulhi(a, b); }
inline unsigned umulhi(unsigned a, unsigned b) { return __umulhi(a, b); }
inline long long __mul64hi(long long a, long long b) { return (long long)((__int128)a * b >> 64); }

// |x - y| + z, and means without overflow, rounded down or up.
inline unsigned __sad(int x, int y, unsigned z) {
    return (x > y ? unsigned(x) - unsigned(y) : unsigned(y) - unsigned(x)) + z;
}
inline unsigned __usad(unsigned x, unsigned y, unsigned z) { return (x > y ? x - y : y - x) + z; }
inline int __hadd(int a, int b) { return int((int64_t(a) + b) >> 1); }
inline int __rhadd(int a, int b) { return int((int64_t(a) + b + 1) >> 1); }
inline unsigned __uhadd(unsigned a, unsigned b) { return unsigned((uint64_t(a) + b) >> 1); }
inline unsigned __urhadd(unsigned a, unsigned b) { return unsigned((uint64_t(a) + b + 1) >> 1); }

// Byte i of the result is that of the 8 bytes y:x which nibble i of `selector` names; the nibble's
// top bit spreads that byte's sign instead.
inline unsigned __byte_perm(unsigned x, unsigned y, unsigned selector) {
    uint64_t bytes = uint64_t(y) << 32 | x;
    unsigned result = 0;
    for (int i = 0; i < 4; ++i) {
        unsigned nibble = selector >> 4 * i & 0xf,
                 byte = unsigned(bytes >> 8 * (nibble & 7)) & 0xff;
        if (nibble & 8) byte = byte & 0x80 ? 0xff : 0;
        result |= byte << 8 * i;
    }
    return result;
}

// The 64 bits high:low, shifted by 0 to 31, or by 0 to 32 where larger shifts are clamped.
inline unsigned __funnelshift_l(unsigned low, unsigned high, unsigned shift) {
    return unsigned((uint64_t(high) << 32 | low) << (shift & 31) >> 32);
}
inline unsigned __funnelshift_r(unsigned low, unsigned high, unsigned shift) {
    return unsigned((uint64_t(high) << 32 | low) >> (shift & 31));
}
inline unsigned __funnelshift_lc(unsigned low, unsigned high, unsigned shift) {
    return shift >= 32 ? low : __funnelshift_l(low, high, shift);
}
inline unsigned __funnelshift_rc(unsigned low, unsigned high, unsigned shift) {
    return shift >= 32 ? high : __funnelshift_r(low, high, shift);
}

// Dot products of four bytes, added to c.
inline int __dp4a(int a, int b, int c) {
    for (int i = 0; i < 32; i += 8) c += int8_t(a >> i) * int8_t(b >> i);
    return c;
}
inline unsigned __dp4a(unsigned a, unsigned b, unsigned c) {
    for (int i = 0; i < 32; i += 8) c += (a >> i & 0xff) * (b >> i & 0xff);
    return c;
}

// The n-th set bit of `mask` from bit `base` on, upwards for n > 0 and downwards for n < 0.
inline unsigned __fns(unsigned mask, unsigned base, int n) {
    if (n == 0) return mask >> base & 1 ? base : 0xffffffffu;
    int step = n > 0 ? 1 : -1;
    for (int bit = int(base), left = n * step; bit >= 0 && bit < 32; bit += step)
        if (mask >> bit & 1 && --left == 0) return unsigned(bit);
    return 0xffffffffu;
}

inline unsigned umin(unsigned a, unsigned b) { return b < a ? b : a; }
inline unsigned umax(unsigned a, unsigned b) { return a < b ? b : a; }
inline long long llmin(long long a, long long b) { return b < a ? b : a; }
inline long long llmax(long long a, long long b) { return a < b ? b : a; }
inline unsigned long long ullmin(unsigned long long a, unsigned long long b) { return min(a, b); }
inline unsigned long long ullmax(unsigned long long a, unsigned long long b) { return max(a, b); }

// CUDA compares a signed with an unsigned number as C does, and a float with a double as doubles.
#define RAYLAB_MIXED(A, B, T)                                                                      \
    inline T min(A a, B b) { return min(static_cast<T>(a), static_cast<T>(b)); }                   \
    inline T max(A a, B b) { return max(static_cast<T>(a), static_cast<T>(b)); }                   \
    inline T min(B a, A b) { return min(static_cast<T>(a), static_cast<T>(b)); }                   \
    inline T max(B a, A b) { return max(static_cast<T>(a), static_cast<T>(b)); }

RAYLAB_MIXED(int, unsigned, unsigned)
RAYLAB_MIXED(long, unsigned long, unsigned long)
RAYLAB_MIXED(long long, unsigned long long, unsigned long long)
RAYLAB_MIXED(float, double, double)

#undef RAYLAB_MIXED
