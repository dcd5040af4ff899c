// cuRAND's uniform, normal and log-normal distributions, by the formulas of its header, so that a
// program gets the numbers that it gets on a GPU, but for the last bits of sinf, cosf and logf.
#pragma once

#include "common/simt/api/arithmetic.h"
#include "common/simt/random/philox.h"
#include "common/simt/random/sobol.h"
#include "common/simt/random/xorwow.h"

namespace raylab::simt {

template <class State>
concept Generator = requires(State* state) {
    curand(state);
};

inline constexpr float two_to_minus_32 = 0x1p-32f;
inline constexpr double two_to_minus_53 = 0x1p-53;

// Greater than 0, up to 1.
inline float uniform(unsigned x) { return float(x) * two_to_minus_32 + two_to_minus_32 / 2; }
inline double uniform(unsigned x, unsigned y) {
    unsigned long long bits = x ^ (unsigned long long)y << 21;
    return double(bits) * two_to_minus_53 + two_to_minus_53 / 2;
}

// Box and Muller 1958: two normal numbers of two uniform ones.
inline float2 box_muller(unsigned x, unsigned y) {
    constexpr float turn = two_to_minus_32 * 6.2831855f;
    float radius = std::sqrt(-2 * std::log(uniform(x))), angle = float(y) * turn + turn / 2;
    return {std::sin(angle) * radius, std::cos(angle) * radius};
}
inline double2 box_muller(unsigned x0, unsigned x1, unsigned y0, unsigned y1) {
    double radius = std::sqrt(-2 * std::log(uniform(x0, x1))), angle = 2 * uniform(y0, y1);
    return {sinpi(angle) * radius, cospi(angle) * radius};
}

} // namespace raylab::simt

template <raylab::simt::Generator State> inline float curand_uniform(State* state) {
    return raylab::simt::uniform(curand(state));
}
template <raylab::simt::Generator State> inline double curand_uniform_double(State* state) {
    unsigned x = curand(state), y = curand(state);
    return raylab::simt::uniform(x, y);
}
// Of Philox, cuRAND takes one number for this.
inline double curand_uniform_double(curandStatePhilox4_32_10_t* state) {
    return curand(state) * 0x1p-32 + 0x1p-32;
}

template <raylab::simt::Generator State> inline float2 curand_normal2(State* state) {
    unsigned x = curand(state), y = curand(state);
    return raylab::simt::box_muller(x, y);
}
template <raylab::simt::Generator State> inline double2 curand_normal2_double(State* state) {
    unsigned x0 = curand(state), x1 = curand(state), y0 = curand(state), y1 = curand(state);
    return raylab::simt::box_muller(x0, x1, y0, y1);
}

namespace raylab::simt {

// For which kind of number the second one of two is kept.
enum Kept { nothing_kept = 0, normal_kept = 1, log_normal_kept = 2 };

template <class State, class Finish>
inline float one_of_two(State* state, Kept kind, Finish finish) {
    if (state->boxmuller_flag == kind) {
        state->boxmuller_flag = nothing_kept;
        return state->boxmuller_extra;
    }
    float2 both = curand_normal2(state);
    state->boxmuller_flag = kind;
    state->boxmuller_extra = finish(both.y);
    return finish(both.x);
}
template <class State, class Finish>
inline double one_of_two_double(State* state, Kept kind, Finish finish) {
    if (state->boxmuller_flag_double == kind) {
        state->boxmuller_flag_double = nothing_kept;
        return state->boxmuller_extra_double;
    }
    double2 both = curand_normal2_double(state);
    state->boxmuller_flag_double = kind;
    state->boxmuller_extra_double = finish(both.y);
    return finish(both.x);
}

} // namespace raylab::simt

template <raylab::simt::Generator State> inline float curand_normal(State* state) {
    return raylab::simt::one_of_two(state, raylab::simt::normal_kept, [](float x) { return x; });
}
template <raylab::simt::Generator State> inline double curand_normal_double(State* state) {
    return raylab::simt::one_of_two_double(state, raylab::simt::normal_kept,
                                           [](double x) { return x; });
}
template <raylab::simt::Generator State>
inline float curand_log_normal(State* state, float mean, float deviation) {
    return raylab::simt::one_of_two(state, raylab::simt::log_normal_kept,
                                    [=](float x) { return std::exp(mean + deviation * x); });
}
template <raylab::simt::Generator State>
inline double curand_log_normal_double(State* state, double mean, double deviation) {
    return raylab::simt::one_of_two_double(state, raylab::simt::log_normal_kept, [=](double x) {
        return std::exp(mean + deviation * x);
    });
}
template <raylab::simt::Generator State>
inline float2 curand_log_normal2(State* state, float mean, float deviation) {
    float2 both = curand_normal2(state);
    return {std::exp(mean + deviation * both.x), std::exp(mean + deviation * both.y)};
}

// Four at once, of Philox alone.
inline float4 curand_uniform4(curandStatePhilox4_32_10_t* state) {
    uint4 x = curand4(state);
    return {raylab::simt::uniform(x.x), raylab::simt::uniform(x.y), raylab::simt::uniform(x.z),
            raylab::simt::uniform(x.w)};
}
inline float4 curand_normal4(curandStatePhilox4_32_10_t* state) {
    uint4 x = curand4(state);
    float2 a = raylab::simt::box_muller(x.x, x.y), b = raylab::simt::box_muller(x.z, x.w);
    return {a.x, a.y, b.x, b.y};
}
inline double2 curand_uniform2_double(curandStatePhilox4_32_10_t* state) {
    uint4 x = curand4(state);
    return {raylab::simt::uniform(x.x, x.y), raylab::simt::uniform(x.z, x.w)};
}
