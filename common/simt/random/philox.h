// cuRAND's Philox generator: Philox4x32-10 of Salmon et al. 2011, "Parallel Random Numbers: As Easy
// as 1, 2, 3". The seed is the key; the subsequence is the upper half of the counter.
#pragma once

#include "common/simt/device_math.h"
#include "common/simt/vector_types.h"

namespace raylab::simt {

inline uint4 philox4x32_10(uint4 counter, uint2 key) {
    for (int round = 0; round < 10; ++round) {
        unsigned high0 = __umulhi(0xd2511f53u, counter.x), low0 = 0xd2511f53u * counter.x;
        unsigned high1 = __umulhi(0xcd9e8d57u, counter.z), low1 = 0xcd9e8d57u * counter.z;
        counter = {high1 ^ counter.y ^ key.x, low1, high0 ^ counter.w ^ key.y, low0};
        key = {key.x + 0x9e3779b9u, key.y + 0xbb67ae85u};
    }
    return counter;
}

} // namespace raylab::simt

struct curandStatePhilox4_32_10 {
    uint4 ctr, output;
    uint2 key;
    unsigned STATE; // how many numbers of `output` are used
    int boxmuller_flag, boxmuller_flag_double;
    float boxmuller_extra;
    double boxmuller_extra_double;
};
using curandStatePhilox4_32_10_t = curandStatePhilox4_32_10;

namespace raylab::simt {

inline void advance_low(uint4& counter, unsigned long long n) {
    unsigned long long low = (unsigned long long)counter.y << 32 | counter.x, sum = low + n;
    counter.x = unsigned(sum);
    counter.y = unsigned(sum >> 32);
    if (sum < low && ++counter.z == 0) ++counter.w;
}
inline void refill(curandStatePhilox4_32_10_t* state) {
    state->output = philox4x32_10(state->ctr, state->key);
}

} // namespace raylab::simt

inline void skipahead(unsigned long long n, curandStatePhilox4_32_10_t* state) {
    state->STATE += unsigned(n & 3);
    n /= 4;
    if (state->STATE > 3) {
        ++n;
        state->STATE -= 4;
    }
    raylab::simt::advance_low(state->ctr, n);
    raylab::simt::refill(state);
}
inline void skipahead_sequence(unsigned long long n, curandStatePhilox4_32_10_t* state) {
    unsigned long long high = ((unsigned long long)state->ctr.w << 32 | state->ctr.z) + n;
    state->ctr.z = unsigned(high);
    state->ctr.w = unsigned(high >> 32);
    raylab::simt::refill(state);
}
inline void curand_init(unsigned long long seed, unsigned long long subsequence,
                        unsigned long long offset, curandStatePhilox4_32_10_t* state) {
    *state = {};
    state->key = {unsigned(seed), unsigned(seed >> 32)};
    skipahead_sequence(subsequence, state);
    skipahead(offset, state);
}

inline unsigned curand(curandStatePhilox4_32_10_t* state) {
    const uint4& output = state->output;
    const unsigned numbers[] = {output.x, output.y, output.z, output.w};
    unsigned number = numbers[state->STATE++];
    if (state->STATE == 4) {
        raylab::simt::advance_low(state->ctr, 1);
        raylab::simt::refill(state);
        state->STATE = 0;
    }
    return number;
}

// The next four numbers.
inline uint4 curand4(curandStatePhilox4_32_10_t* state) {
    uint4 numbers;
    numbers.x = curand(state);
    numbers.y = curand(state);
    numbers.z = curand(state);
    numbers.w = curand(state);
    return numbers;
}
