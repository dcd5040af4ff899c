// cuRAND's default generator: Marsaglia's xorwow (2003, "Xorshift RNGs"), seeded as cuRAND's manual
// and header say. Subsequences are 2^67 numbers apart.
#pragma once

struct curandStateXORWOW {
    unsigned d, v[5];
    int boxmuller_flag, boxmuller_flag_double;
    float boxmuller_extra;
    double boxmuller_extra_double;
};
using curandStateXORWOW_t = curandStateXORWOW;
using curandState = curandStateXORWOW;
using curandState_t = curandStateXORWOW;

namespace raylab::simt {

// Leaves out n * 2^log2_stride numbers; the counter `d` apart.
void skip_xorwow(unsigned v[5], unsigned long long n, int log2_stride);

} // namespace raylab::simt

inline void skipahead(unsigned long long n, curandStateXORWOW_t* state) {
    raylab::simt::skip_xorwow(state->v, n, 0);
    state->d += 362437u * unsigned(n);
}
inline void skipahead_sequence(unsigned long long n, curandStateXORWOW_t* state) {
    raylab::simt::skip_xorwow(state->v, n, 67); // of d's period, 2^32, this is a multiple
}
inline void curand_init(unsigned long long seed, unsigned long long subsequence,
                        unsigned long long offset, curandStateXORWOW_t* state) {
    // Bits of the seed, salted and mixed, change the state that Marsaglia gave.
    unsigned low = (unsigned(seed) ^ 0xaad26b49u) * 1099087573u;
    unsigned high = (unsigned(seed >> 32) ^ 0xf7dcefddu) * 2591861531u;
    *state = {};
    state->d = 6615241u + high + low;
    state->v[0] = 123456789u + low;
    state->v[1] = 362436069u ^ low;
    state->v[2] = 521288629u + high;
    state->v[3] = 88675123u ^ high;
    state->v[4] = 5783321u + low;
    skipahead_sequence(subsequence, state);
    skipahead(offset, state);
}

inline unsigned curand(curandStateXORWOW_t* state) {
    unsigned* v = state->v;
    unsigned t = v[0] ^ v[0] >> 2;
    v[0] = v[1];
    v[1] = v[2];
    v[2] = v[3];
    v[3] = v[4];
    v[4] = (v[4] ^ v[4] << 4) ^ (t ^ t << 1);
    state->d += 362437u;
    return v[4] + state->d;
}
