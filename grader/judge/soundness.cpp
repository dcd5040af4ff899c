// One pass over the pixels; each bad pixel is counted under the first thing that is wrong with it.
#include "grader/judge/soundness.h"

#include <fmt/format.h>

#include <bit>

namespace raylab {
namespace {

bool is_unwritten(Vec3 v) {
    return std::bit_cast<std::uint32_t>(v.x) == unwritten_bits ||
           std::bit_cast<std::uint32_t>(v.y) == unwritten_bits ||
           std::bit_cast<std::uint32_t>(v.z) == unwritten_bits;
}

} // namespace

std::string to_string(const Region& r) {
    return fmt::format("x {} to {}, y {} to {}", r.x0, r.x1 - 1, r.y0, r.y1 - 1);
}

void poison(Image& image) {
    image.mean.assign(image.pixels(), Vec3(std::bit_cast<float>(unwritten_bits)));
}

Soundness check_soundness(const Image& image, int width, int height) {
    Soundness result;
    if (image.width != width || image.height != height || image.mean.size() != image.pixels()) {
        result.verdict.sentence = fmt::format("The image is {} x {} pixels; {} x {} were expected.",
                                              image.width, image.height, width, height);
        return result;
    }
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const Vec3 v = image.mean[i];
        std::size_t* count = is_unwritten(v)                 ? &result.unwritten
                             : !is_finite(v)                 ? &result.not_finite
                             : v.x < 0 || v.y < 0 || v.z < 0 ? &result.negative
                                                             : nullptr;
        if (!count) continue;
        ++*count;
        if (result.first_x >= 0) continue;
        result.first_x = static_cast<int>(i % static_cast<std::size_t>(width));
        result.first_y = static_cast<int>(i / static_cast<std::size_t>(width));
    }
    result.verdict.passed = result.first_x < 0;
    result.verdict.sentence =
        result.verdict.passed
            ? "Every pixel is written, finite and not negative."
            : fmt::format("Of {} pixels {} were never written, {} are NaN or infinite and {} are "
                          "negative; the first is ({}, {}).",
                          image.pixels(), result.unwritten, result.not_finite, result.negative,
                          result.first_x, result.first_y);
    return result;
}

} // namespace raylab
