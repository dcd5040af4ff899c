// Skipping numbers of xorwow; see random/xorwow.h.
//
// A step is a linear map of the 160 bits of v over the field of two elements. Its powers of two
// steps are made once, by squaring; skipping n numbers applies those of n's bits.
#include "common/simt/random/xorwow.h"

#include <array>
#include <bit>
#include <memory>

namespace raylab::simt {

namespace {

constexpr int words = 5, bits = words * 32, powers = 67 + 64;
using State = std::array<unsigned, words>;

// Column i is the image of bit i.
struct Map {
    std::array<State, bits> columns;

    State apply(const State& state) const {
        State image{};
        for (int word = 0; word < words; ++word)
            for (unsigned rest = state[word]; rest; rest &= rest - 1) {
                const State& column = columns[word * 32 + std::countr_zero(rest)];
                for (int i = 0; i < words; ++i) image[i] ^= column[i];
            }
        return image;
    }
};

// [k] leaves out 2^k numbers.
const std::array<Map, powers>& skips() {
    static const auto made = [] {
        auto maps = std::make_unique<std::array<Map, powers>>();
        for (int bit = 0; bit < bits; ++bit) {
            curandStateXORWOW one{};
            one.v[bit / 32] = 1u << bit % 32;
            curand(&one);
            for (int word = 0; word < words; ++word) (*maps)[0].columns[bit][word] = one.v[word];
        }
        for (int k = 1; k < powers; ++k)
            for (int bit = 0; bit < bits; ++bit)
                (*maps)[k].columns[bit] = (*maps)[k - 1].apply((*maps)[k - 1].columns[bit]);
        return maps;
    }();
    return *made;
}

} // namespace

void skip_xorwow(unsigned v[5], unsigned long long n, int log2_stride) {
    if (n == 0) return;
    State state;
    for (int word = 0; word < words; ++word) state[word] = v[word];
    for (int k = log2_stride; n; n >>= 1, ++k)
        if (n & 1) state = skips()[k].apply(state);
    for (int word = 0; word < words; ++word) v[word] = state[word];
}

} // namespace raylab::simt
