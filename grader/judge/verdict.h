// What every judgement ends in: passed or not, and one sentence for people that says what was
// measured.
#pragma once

#include <string>
#include <vector>

namespace raylab {

struct Verdict {
    bool passed = false;
    std::string sentence;
    std::vector<std::string> hints; // worth knowing, never decided on
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
