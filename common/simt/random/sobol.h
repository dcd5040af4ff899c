// cuRAND's Sobol generators of 32 and 64 bits, for up to eight dimensions, one generator each.
//
// A dimension has a direction vector for each bit (Joe and Kuo 2008, "Constructing Sobol Sequences
// with Better Two-Dimensional Projections", file new-joe-kuo-6). Number n is the exclusive or of
// those at the bits of n's Gray code, so from n to n + 1 one vector changes (Antonov and Saleev
// 1979).
#pragma once

#include <cstddef>
#include <cstdint>

using curandDirectionVectors32_t = unsigned[32];
using curandDirectionVectors64_t = unsigned long long[64];

struct curandStateSobol32 {
    unsigned i, x;
    unsigned direction_vectors[32];
};
struct curandStateSobol64 {
    unsigned long long i, x;
    unsigned long long direction_vectors[64];
};
using curandStateSobol32_t = curandStateSobol32;
using curandStateSobol64_t = curandStateSobol64;

namespace raylab::simt {

inline constexpr unsigned sobol_dimensions = 8;

// vectors[k] for the k-th bit of n, of dimension `dimension` from 0 on.
template <class Bits> void fill_direction_vectors(unsigned dimension, Bits* vectors) {
    // Degree of the polynomial, its inner coefficients, and the first vectors' numerators.
    static constexpr struct {
        unsigned degree, coefficients, m[5];
    } table[sobol_dimensions - 1] = {
        {1, 0, {1}},          {2, 1, {1, 3}},        {3, 1, {1, 3, 1}},       {3, 2, {1, 1, 1}},
        {4, 1, {1, 1, 3, 3}}, {4, 4, {1, 3, 5, 13}}, {5, 2, {1, 1, 5, 5, 17}}};
    constexpr unsigned bits = sizeof(Bits) * 8;
    for (unsigned k = 0; k < bits; ++k) {
        if (dimension == 0) {
            vectors[k] = Bits(1) << (bits - 1 - k);
            continue;
        }
        const auto& [degree, coefficients, m] = table[dimension - 1];
        if (k < degree) {
            vectors[k] = Bits(m[k]) << (bits - 1 - k);
            continue;
        }
        Bits vector = vectors[k - degree] ^ vectors[k - degree] >> degree;
        for (unsigned j = 1; j < degree; ++j)
            if (coefficients >> (degree - 1 - j) & 1) vector ^= vectors[k - j];
        vectors[k] = vector;
    }
}

// Number n of a dimension.
template <class Bits> Bits sobol_number(const Bits* vectors, Bits n) {
    Bits x = 0;
    for (Bits gray = n ^ n >> 1; gray; gray &= gray - 1)
        x ^= vectors[__builtin_ctzll((unsigned long long)gray)];
    return x;
}

template <class State, class Bits> void init_sobol(const Bits* vectors, Bits offset, State* state) {
    for (size_t k = 0; k < sizeof(Bits) * 8; ++k) state->direction_vectors[k] = vectors[k];
    state->i = offset;
    state->x = sobol_number(vectors, offset);
}

template <class State> auto next_sobol(State* state) {
    const auto x = state->x;
    const auto changed = ~(unsigned long long)state->i; // its lowest one is the bit that changes
    if (state->i + 1) state->x ^= state->direction_vectors[__builtin_ctzll(changed)];
    ++state->i;
    return x;
}

} // namespace raylab::simt

inline void curand_init(const unsigned* direction_vectors, unsigned offset,
                        curandStateSobol32_t* state) {
    raylab::simt::init_sobol(direction_vectors, offset, state);
}
inline void curand_init(const unsigned long long* direction_vectors, unsigned long long offset,
                        curandStateSobol64_t* state) {
    raylab::simt::init_sobol(direction_vectors, offset, state);
}
inline unsigned curand(curandStateSobol32_t* state) { return raylab::simt::next_sobol(state); }
inline unsigned long long curand(curandStateSobol64_t* state) {
    return raylab::simt::next_sobol(state);
}
inline double curand_uniform_double(curandStateSobol32_t* state) {
    return curand(state) * 0x1p-32 + 0x1p-32;
}
inline float curand_uniform(curandStateSobol64_t* state) {
    return float(curand(state)) * 0x1p-64f + 0x1p-65f;
}
inline double curand_uniform_double(curandStateSobol64_t* state) {
    return double(curand(state) >> 11) * 0x1p-53 + 0x1p-54;
}
