// A permutation without a table: which pixel of a fill a slot gets.
//
// A random order of the pixels makes reads of memory slower and leaves the image as it is: no
// result may depend on the slot of a path, and `--shuffle` shows that none does. Kensler,
// Correlated Multi-Jittered Sampling, Pixar 13-01, 2013, section 4.
#pragma once

#include "common/math/hd.h"

#include <cstdint>

namespace raylab::lab03 {

// The i-th entry of permutation `seed` of 0 ... n - 1; seed 0 is the identity. A pass of the loop
// permutes the numbers below the next power of two. If i becomes n or more, the loop permutes i
// again, until i is below n: such walks never meet, so the result is a permutation of 0 ... n - 1.
HD std::uint32_t shuffled(std::uint32_t i, std::uint32_t n, std::uint32_t seed) {
    if (seed == 0 || n < 2) return i;
    std::uint32_t mask = n - 1;
    for (int shift = 1; shift < 32; shift *= 2) mask |= mask >> shift;
    do {
        for (std::uint32_t round = 0; round < 3; ++round) {
            i = (i ^ seed) & mask;
            i = i * 0xe170893du & mask; // odd: a bijection mod 2^k
            i ^= i >> 4;
            i = (i + (seed >> (8 * round))) & mask;
            i = i * 0x0929eb3fu & mask;
            i ^= (i & mask) >> 1;
        }
    } while (i >= n);
    return i;
}

} // namespace raylab::lab03
