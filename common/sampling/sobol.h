// Owen-scrambled Sobol points in two dimensions: random points that are spread very evenly.
// Burley, Practical Hash-based Owen Scrambling, JCGT 9(4), 2020.
//
// The first 2^m points are a (0,m,2)-net: cut the unit square into 2^m equal boxes 2^-a wide and
// 2^-(m-a) high, for any a, and each box holds exactly one point. Scrambling keeps that and makes
// each point uniform, so an average over them is unbiased. Pairs of dimensions are padded: each
// pair uses this sequence with its own scrambling, in its own shuffled order.
#pragma once

#include "common/sampling/hash.h"

namespace raylab {

HD std::uint32_t reverse_bits(std::uint32_t x) {
#if defined(__CUDA_ARCH__)
    return __brev(x);
#else
    x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
    x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
    x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
    return __builtin_bswap32(x);
#endif
}

// Owen scrambling of a number whose bits are reversed, lowest bit most significant: bit i is
// flipped or not by a random function of the bits below it. Additions and products carry only
// upwards, so any chain of them does this; these constants make the flips look random (the
// Laine-Karras hash with Vegdahl's constants, Building a Better LK Hash, 2021).
HD std::uint32_t owen_scramble_reversed(std::uint32_t x, std::uint32_t key) {
    x ^= x * 0x3d20adeau;
    x += key;
    x *= key >> 16 | 1;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

// The second Sobol dimension of an index, bits reversed. Its generator matrix is Pascal's triangle
// mod 2: bit j of the result is the sum over bits k of C(k, j) i_k, and by Lucas' theorem C(k, j)
// is odd exactly when j's binary digits are a subset of k's. A sum over supersets is a butterfly:
// five steps, one for each digit of a bit's position.
HD std::uint32_t sobol_second_reversed(std::uint32_t i) {
    i ^= i >> 1 & 0x55555555u;
    i ^= i >> 2 & 0x33333333u;
    i ^= i >> 4 & 0x0f0f0f0fu;
    i ^= i >> 8 & 0x00ff00ffu;
    i ^= i >> 16;
    return i;
}

// Dimensions three and four, bits reversed, have no such short form: each bit of the index adds its
// direction number. They come from the primitive polynomials x^2 + x + 1 and x^3 + x + 1 with the
// first numbers m = 1, 3 and 1, 3, 1 (Joe and Kuo, Constructing Sobol Sequences with Better
// Two-Dimensional Projections, 2008), by the recurrence v_k = 2^d v_(k-d) + ... of Bratley and Fox.
struct DirectionNumbers {
    std::uint32_t third[32] = {}, fourth[32] = {}; // bit 0: the first binary digit

    HD constexpr DirectionNumbers() {
        const std::uint32_t m3[2] = {1, 3}, m4[3] = {1, 3, 1};
        std::uint32_t v3[32] = {}, v4[32] = {}; // most significant bit first
        for (int k = 0; k < 32; ++k) {
            v3[k] = k < 2 ? m3[k] << (31 - k) : v3[k - 1] ^ v3[k - 2] ^ v3[k - 2] >> 2;
            v4[k] = k < 3 ? m4[k] << (31 - k) : v4[k - 2] ^ v4[k - 3] ^ v4[k - 3] >> 3;
            for (int bit = 0; bit < 32; ++bit) {
                third[k] |= (v3[k] >> bit & 1) << (31 - bit);
                fourth[k] |= (v4[k] >> bit & 1) << (31 - bit);
            }
        }
    }
};

// Owen scrambling of the index is a shuffle that keeps blocks of 2^m points together.
HD std::uint32_t shuffled_index(std::uint32_t index, std::uint32_t key) {
    return reverse_bits(owen_scramble_reversed(reverse_bits(index), key));
}

// Point `index` of the sequence that `key` chooses, in [0, 1)^2. The first Sobol dimension is the
// index itself with its bits reversed (van der Corput's sequence).
HD Vec2 owen_sobol_2d(std::uint32_t index, Words key) {
    const std::uint32_t i = shuffled_index(index, key.x);
    const std::uint32_t x = reverse_bits(owen_scramble_reversed(i, key.y));
    const std::uint32_t y = reverse_bits(owen_scramble_reversed(sobol_second_reversed(i), key.z));
    return Vec2(to_unit(x), to_unit(y));
}

// Dimensions three and four of that point, in [0, 1)^2. shuffle: the key.x that gave dimensions one
// and two; their scrambling is key's.
HD Vec2 owen_sobol_next_2d(std::uint32_t index, std::uint32_t shuffle, Words key) {
    constexpr DirectionNumbers numbers;
    const std::uint32_t i = shuffled_index(index, shuffle);
    std::uint32_t third = 0, fourth = 0;
    for (int bit = 0; bit < 32; ++bit) {
        const std::uint32_t mask = 0u - (i >> bit & 1);
        third ^= numbers.third[bit] & mask;
        fourth ^= numbers.fourth[bit] & mask;
    }
    const std::uint32_t x = reverse_bits(owen_scramble_reversed(third, key.y));
    const std::uint32_t y = reverse_bits(owen_scramble_reversed(fourth, key.z));
    return Vec2(to_unit(x), to_unit(y));
}

} // namespace raylab
