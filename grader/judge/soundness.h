// Before all else: does the image have the right size, and is every pixel written, finite and not
// negative? An all-NaN image must never pass because no comparison with NaN is true.
#pragma once

#include "common/image/image.h"
#include "grader/judge/verdict.h"

#include <cstdint>

namespace raylab {

// A NaN that no arithmetic makes. Fill the image with it before the render: what still holds it
// afterwards was never written.
constexpr std::uint32_t unwritten_bits = 0x7fc0dead;
void poison(Image& image);

struct Soundness {
    Verdict verdict;
    std::size_t unwritten = 0, not_finite = 0, negative = 0; // pixels, each counted once
    int first_x = -1, first_y = -1;                          // of the first bad pixel
};

// Checks `image` on its own, and its size against `width` x `height`.
Soundness check_soundness(const Image& image, int width, int height);

} // namespace raylab
