// Floating-point numbers of 16 bits: half (5 bits of exponent, 10 of fraction) and bfloat16 (8 and
// 7).
//
// Every operation is done in float and rounded once more. That gives the correctly rounded result:
// a float has more than twice the bits (Figueroa 1995, "When is double rounding innocuous?").
#pragma once

#include "common/simt/api/arithmetic.h"

#include <algorithm>
#include <type_traits>

namespace raylab::simt {

// Nearest even, to zero, up, down.
enum class Round { nearest, zero, up, down };

// A double that rounds to any of these formats as the exact sum a + b does: what is left out goes
// into the last bit ("rounding to odd", Boldo and Melquiond 2008).
inline double odd_sum(double a, double b) {
    double sum = a + b, b_part = sum - a;
    double rest = (a - (sum - b_part)) + (b - b_part);
    if (rest == 0 || !std::isfinite(sum) || (std::bit_cast<uint64_t>(sum) & 1)) return sum;
    return std::nextafter(sum, rest > 0 ? INFINITY : -INFINITY);
}

// `exponent_bits` and `fraction_bits` of the format; 1 + both is 16.
template <int exponent_bits, int fraction_bits> struct Format {
    static constexpr int bias = (1 << (exponent_bits - 1)) - 1;
    static constexpr uint16_t infinity = ((1 << exponent_bits) - 1) << fraction_bits;
    static constexpr uint16_t largest = infinity - 1, nan = 0x7fff;

    static constexpr double power_of_two(int exponent) {
        return std::bit_cast<double>(uint64_t(1023 + exponent) << 52);
    }

    static float to_float(uint16_t bits) {
        constexpr int shift = 23 - fraction_bits; // to a float's fraction
        uint32_t size = uint32_t(bits & 0x7fff) << shift, sign = uint32_t(bits >> 15) << 31;
        if ((bits & 0x7fff) >= infinity) return std::bit_cast<float>(0x7f800000u | size | sign);
        // A float with this exponent, but of another bias: scaling mends that, also for the numbers
        // below the smallest normal one.
        float value = std::bit_cast<float>(size) * float(power_of_two(127 - bias));
        return sign ? -value : value;
    }

    static uint16_t from(double value, Round round = Round::nearest) {
        if (value != value) return nan;
        uint16_t sign = std::signbit(value) ? 0x8000 : 0;
        double size = std::abs(value);
        // Away from zero, or towards it, seen from the size.
        if (sign && round == Round::up)
            round = Round::zero;
        else if (sign && round == Round::down)
            round = Round::up;
        else if (round == Round::down)
            round = Round::zero;
        if (size == INFINITY) return sign | infinity;
        if (size == 0) return sign;
        // In units of the last place of the format, at this exponent or the smallest one.
        int exponent = std::max(int(std::bit_cast<uint64_t>(size) >> 52) - 1023, 1 - bias);
        double units = size * power_of_two(fraction_bits - exponent);
        double whole = round == Round::zero ? std::floor(units)
                       : round == Round::up ? std::ceil(units)
                                            : std::nearbyint(units);
        // Carries from fraction to exponent are what they should be.
        long bits = long(whole) + (long(exponent + bias - 1) << fraction_bits);
        if (bits >= infinity) bits = round == Round::zero ? largest : infinity;
        return uint16_t(sign | bits);
    }
};

} // namespace raylab::simt
