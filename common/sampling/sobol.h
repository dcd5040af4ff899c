// Owen-scrambled Sobol points in two dimensions: random, yet spread as evenly as points can be.
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

// Point `index` of the sequence that `key` chooses, in [0, 1)^2. The first Sobol dimension is the
// index itself with its bits reversed (van der Corput's sequence).
HD Vec2 owen_sobol_2d(std::uint32_t index, Words key) {
    // Owen scrambling of the index is a shuffle that keeps blocks of 2^m points together.
    const std::uint32_t i = reverse_bits(owen_scramble_reversed(reverse_bits(index), key.x));
    const std::uint32_t x = reverse_bits(owen_scramble_reversed(i, key.y));
    const std::uint32_t y = reverse_bits(owen_scramble_reversed(sobol_second_reversed(i), key.z));
    return Vec2(to_unit(x), to_unit(y));
}

} // namespace raylab
