// One rule for images and ids: agree, or hold a neighbour's value at an edge, or be wrong.
#include "grader/judge/exact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace raylab {
namespace {

// agrees(i, j): does the image's value at pixel i agree with the reference's at pixel j?
template <class Agrees>
ExactResult judge(int width, int height, const ExactOptions& options, Agrees agrees) {
    ExactResult result;
    const int pixels = width * height;
    result.edge_allowed = static_cast<std::size_t>(options.edge_share * pixels);
    for (int i = 0; i < pixels; ++i) {
        if (agrees(i, i)) continue;
        const int x = i % width, y = i / width;
        bool neighbour = false;
        for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u)
                neighbour = neighbour || agrees(i, v * width + u);
        const bool first = neighbour ? result.edge + result.wrong == 0 : result.wrong == 0;
        ++(neighbour ? result.edge : result.wrong);
        if (!first) continue;
        result.first_x = x;
        result.first_y = y;
    }
    result.verdict.passed = result.wrong == 0 && result.edge <= result.edge_allowed;
    if (result.wrong + result.edge == 0)
        result.verdict.sentence = fmt::format("All {} pixels are the reference's.", pixels);
    else
        result.verdict.sentence = fmt::format("Of {} pixels {} hold a wrong value and {} a "
                                              "neighbour's ({} are allowed, at edges); the "
                                              "first is ({}, {}).",
                                              pixels, result.wrong, result.edge,
                                              result.edge_allowed, result.first_x, result.first_y);
    return result;
}

} // namespace

ExactResult judge_exact(const Image& image, const Image& reference, const ExactOptions& options) {
    ExactResult result;
    result.soundness = check_soundness(image, reference.width, reference.height);
    if (!result.soundness.verdict.passed) {
        result.verdict = result.soundness.verdict;
        return result;
    }
    const Soundness soundness = result.soundness;
    result = judge(image.width, image.height, options, [&](int i, int j) {
        const Vec3 a = image.mean[static_cast<std::size_t>(i)];
        const Vec3 b = reference.mean[static_cast<std::size_t>(j)];
        for (int c = 0; c < 3; ++c)
            if (!(std::abs(double(a[c]) - double(b[c])) <=
                  options.absolute_tolerance + options.relative_tolerance * std::abs(double(b[c]))))
                return false;
        return true;
    });
    result.soundness = soundness;
    return result;
}

ExactResult judge_exact(const std::vector<int>& ids, const std::vector<int>& reference, int width,
                        int height, const ExactOptions& options) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (reference.size() != pixels)
        throw std::invalid_argument("judge_exact: the reference does not have width x height ids");
    if (ids.size() != pixels) {
        ExactResult result;
        result.verdict.sentence =
            fmt::format("There are {} ids; {} were expected.", ids.size(), pixels);
        return result;
    }
    return judge(width, height, options, [&](int i, int j) {
        return ids[static_cast<std::size_t>(i)] == reference[static_cast<std::size_t>(j)];
    });
}

} // namespace raylab
