// Random bits as a function of four words: pcg4d, a hash made to be evaluated in one go.
// Jarzynski and Olano, Hash Functions for GPU Rendering, JCGT 9(3), 2020.
#pragma once

#include "common/math/vec.h"

#include <cstdint>

namespace raylab {

struct Words {
    std::uint32_t x, y, z, w;
};

// A bijection of 128 bits. Two inputs that differ in any bit give two outputs that look unrelated.
// A step of a congruential generator on each word, then each word is mixed into the next, twice.
// Products carry upwards only, so before each round a shift brings high bits down. The paper shifts
// before the second round alone, which leaves the upper seven bits of each word almost unmixed:
// seeds 1 and 0x80000001 would give nearly the same image.
HD Words pcg4d(Words v) {
    v.x = v.x * 1664525u + 1013904223u;
    v.y = v.y * 1664525u + 1013904223u;
    v.z = v.z * 1664525u + 1013904223u;
    v.w = v.w * 1664525u + 1013904223u;
    for (int round = 0; round < 2; ++round) {
        v.x ^= v.x >> 16, v.y ^= v.y >> 16, v.z ^= v.z >> 16, v.w ^= v.w >> 16;
        v.x += v.y * v.w, v.y += v.z * v.x, v.z += v.x * v.y, v.w += v.y * v.z;
    }
    return v;
}

// The upper 24 bits as a number in [0, 1): every value is a float, so none rounds up to 1.
HD float to_unit(std::uint32_t bits) { return (bits >> 8) * 0x1p-24f; }

} // namespace raylab
