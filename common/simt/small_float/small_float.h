// __half and __nv_bfloat16: a number of 16 bits, and what can be done with it by operators.
#pragma once

#include "common/simt/atomics.h"
#include "common/simt/small_float/format.h"

namespace raylab::simt {

template <class Format> struct SmallFloat {
    using Bits = Format;
    uint16_t bits;

    SmallFloat() = default;
    template <class T>
    requires std::is_arithmetic_v<T> SmallFloat(T value) : bits(Format::from(double(value))) {}

    template <class Other>
    explicit SmallFloat(SmallFloat<Other> value) : SmallFloat(float(value)) {}

    operator float() const { return Format::to_float(bits); }

    static SmallFloat from_bits(unsigned bits) {
        SmallFloat value;
        value.bits = uint16_t(bits);
        return value;
    }

    using Self = SmallFloat;
    friend Self operator+(Self a, Self b) { return float(a) + float(b); }
    friend Self operator-(Self a, Self b) { return float(a) - float(b); }
    friend Self operator*(Self a, Self b) { return float(a) * float(b); }
    friend Self operator/(Self a, Self b) { return float(a) / float(b); }
    friend Self operator-(Self a) { return from_bits(a.bits ^ 0x8000u); }
    friend Self operator+(Self a) { return a; }
    friend Self& operator+=(Self& a, Self b) { return a = a + b; }
    friend Self& operator-=(Self& a, Self b) { return a = a - b; }
    friend Self& operator*=(Self& a, Self b) { return a = a * b; }
    friend Self& operator/=(Self& a, Self b) { return a = a / b; }
    friend Self& operator++(Self& a) { return a += Self(1); }
    friend Self& operator--(Self& a) { return a -= Self(1); }
    friend bool operator==(Self a, Self b) { return float(a) == float(b); }
    friend bool operator!=(Self a, Self b) { return float(a) != float(b); }
    friend bool operator<(Self a, Self b) { return float(a) < float(b); }
    friend bool operator>(Self a, Self b) { return float(a) > float(b); }
    friend bool operator<=(Self a, Self b) { return float(a) <= float(b); }
    friend bool operator>=(Self a, Self b) { return float(a) >= float(b); }
};

// Two of them, which a GPU handles at once.
template <class Number> struct alignas(4) SmallFloat2 {
    using Element = Number;
    Number x, y;

    using Self = SmallFloat2;
    friend Self operator+(Self a, Self b) { return {a.x + b.x, a.y + b.y}; }
    friend Self operator-(Self a, Self b) { return {a.x - b.x, a.y - b.y}; }
    friend Self operator*(Self a, Self b) { return {a.x * b.x, a.y * b.y}; }
    friend Self operator/(Self a, Self b) { return {a.x / b.x, a.y / b.y}; }
    friend Self operator-(Self a) { return {-a.x, -a.y}; }
    friend Self& operator+=(Self& a, Self b) { return a = a + b; }
    friend Self& operator-=(Self& a, Self b) { return a = a - b; }
    friend Self& operator*=(Self& a, Self b) { return a = a * b; }
    friend Self& operator/=(Self& a, Self b) { return a = a / b; }
    friend bool operator==(Self a, Self b) { return a.x == b.x && a.y == b.y; }
    friend bool operator!=(Self a, Self b) { return a.x != b.x && a.y != b.y; } // CUDA's
};

template <class T> inline constexpr bool is_small = false;
template <class F> inline constexpr bool is_small<SmallFloat<F>> = true;
template <class T> inline constexpr bool is_small_pair = false;
template <class T> inline constexpr bool is_small_pair<SmallFloat2<T>> = true;

template <class T>
concept Small = is_small<T>;
template <class T>
concept SmallPair = is_small_pair<T>;

// function(a...) for each half of pairs.
template <SmallPair P, class Function, class... Pairs>
inline auto for_both(Function function, P a, Pairs... more) {
    return P{function(a.x, more.x...), function(a.y, more.y...)};
}

// a * b + c, rounded once.
template <Small H> inline H fused(H a, H b, H c) {
    double product = double(float(a)) * float(b);
    return H(odd_sum(product, float(c)));
}
template <Small H> inline H clamp01(H a) { return a > H(0) ? (a < H(1) ? a : H(1)) : H(0); }

} // namespace raylab::simt
