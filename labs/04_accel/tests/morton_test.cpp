// Task 4.4: codes along the Morton curve.
#include "common/task/facts.h"
#include "labs/04_accel/tests/cases.h"
#include "labs/04_accel/tests/lbvh_cases.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace raylab::lab04 {

namespace {

using namespace task;

constexpr Bounds unit_cube{Vec3(0), Vec3(1)};

Vec3 centre_of_cell(int x, int y, int z) {
    return (Vec3(x, y, z) + 0.5f) / float(1 << morton_bits);
}

TEST(Task4_4, SpreadPutsTwoZerosInFrontOfEachBit) {
    for (int bit = 0; bit < morton_bits; ++bit)
        if (!expect_equal(fmt::format("spread() of bit {} alone: the number", bit),
                          spread(1u << bit), 1ll << 3 * bit,
                          "a mask of spread() loses this bit, or a move is left out or goes too "
                          "far"))
            return;
}

TEST(Task4_4, CodesAreTheBitsOfThreeCoordinatesInTurns) {
    expect_equal("the code of cell (1, 0, 0)", morton_code(centre_of_cell(1, 0, 0), unit_cube), 4,
                 "x y z in turns, x highest in each group of three bits");
    Dice dice(1);
    for (int i = 0; i < 10000; ++i) {
        const int x = dice.below(1024), y = dice.below(1024), z = dice.below(1024);
        const std::uint32_t code = morton_code(centre_of_cell(x, y, z), unit_cube);
        if (!expect(code == code_of_cells(x, y, z),
                    fmt::format("the code of cell ({}, {}, {}) of 1024 on each axis should be "
                                "{:030b} but is {:030b}; the likely cause: the bits of x, y and z "
                                "in turns, x highest, of the cell that floor(1024 share) is",
                                x, y, z, code_of_cells(x, y, z), code)))
            return;
    }
}

TEST(Task4_4, ABoxMayLieAnywhere) {
    const Bounds box{Vec3(-3, 5, 100), Vec3(-1, 9, 101)};
    expect_equal("the code of the lower corner of a box that does not begin at 0",
                 morton_code(box.low, box), 0,
                 "how far p is on its way through the box: from "
                 "box.low, by the box's extent");
    const Vec3 middle = 0.5f * (box.low + box.high);
    expect_equal("the code of its middle", morton_code(middle, box), 7 << 3 * (morton_bits - 1),
                 "how far p is on its way through the box: from box.low, by the box's extent");
}

TEST(Task4_4, PointsOnAndOutsideTheBoxAreInItsOuterCells) {
    const std::uint32_t last = (1u << 3 * morton_bits) - 1;
    expect_equal("the code of the near corner", morton_code(Vec3(0), unit_cube), 0,
                 "it is in the first cell");
    expect_equal("the code of the far corner", morton_code(Vec3(1), unit_cube), last,
                 "what lies on the far face is in the last cell, 1023, not in cell 1024");
    expect_equal("the code of a point before the box", morton_code(Vec3(-5), unit_cube), 0,
                 "what lies outside is in the first cell, or in the last cell");
    expect_equal("the code of a point behind the box", morton_code(Vec3(7), unit_cube), last,
                 "what lies outside is in the first cell, or in the last cell");
}

TEST(Task4_4, AFlatBoxHasCodes) {
    const Bounds floor{Vec3(0), Vec3(1, 0, 1)};
    expect_equal("the code of a point in a box without height",
                 morton_code(Vec3(0.999f, 0, 0), floor), code_of_cells(1022, 0, 0),
                 "on an axis without extent all are in cell 0: 0 / 0 is no number");
}

} // namespace

} // namespace raylab::lab04
