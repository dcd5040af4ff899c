// The result of a judgement: passed or not, one sentence for people that says what was measured,
// and the figures.
#pragma once

#include "grader/judge/metrics.h"

#include <optional>
#include <string>
#include <vector>

namespace raylab {

// Measures of an image against another of the same size. The judge computes them once; pages and
// tables show these numbers.
struct Measures {
    Metrics metrics;
    ZMap z_map;
};

struct Verdict {
    bool passed = false;
    std::string sentence;
    std::vector<std::string> hints = {}; // worth knowing, never decided on
    // Of the two images that were judged; nothing if one of them is unsound.
    std::optional<Measures> measured = {};
};

// A rectangle of pixels, [x0, x1) x [y0, y1).
struct Region {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int pixels() const { return (x1 - x0) * (y1 - y0); }
    bool operator==(const Region&) const = default;
};

// "x 32 to 47, y 0 to 15".
std::string to_string(const Region& region);

} // namespace raylab
