// The compiler rounds where the language says so: g++ 12 would not (cmake/RaylabFlags.cmake).
#include "common/math/vec.h"

#include <gtest/gtest.h>

namespace raylab {
namespace {

void round_to_float(const DVec3& p, DVec3& rounded) { rounded = DVec3(Vec3(p)); }

TEST(Rounding, HoldsForDoublesSideBySide) {
    void (*volatile round)(const DVec3&, DVec3&) = round_to_float; // or it is done when compiled
    DVec3 rounded;
    round(DVec3(0.1, 0.2, 0.3), rounded);
    EXPECT_EQ(rounded.x, 0x1.99999ap-4); // the floats next to .1, .2 and .3
    EXPECT_EQ(rounded.y, 0x1.99999ap-3);
    EXPECT_EQ(rounded.z, 0x1.333334p-2);
}

} // namespace
} // namespace raylab
