// Lab 04 draws lab 02's image to the last bit, whatever its structure over the triangles and
// however rays walk it: ties go to the lowest id, and no walk loses a hit.
#include "app/tests/agreement.h"

#include <gtest/gtest.h>

namespace raylab::app {

namespace {

// Every structure with every walk that it has.
std::vector<AccelSettings> all_walks(const Scene& scene) {
    std::vector<AccelSettings> all;
    for (int accel = 0; accel < static_cast<int>(std::size(accel_names)); ++accel)
        for (int walk = 0; walk < static_cast<int>(std::size(walk_names)); ++walk) {
            const AccelSettings settings{static_cast<AccelKind>(accel),
                                         static_cast<WalkKind>(walk)};
            try {
                find_lab("04").make(scene, {.accel = settings});
                all.push_back(settings);
            } catch (const SettingsError&) {
            }
        }
    return all;
}

class EveryStructure : public testing::TestWithParam<std::string> {
  protected:
    static void SetUpTestSuite() { walks_ = all_walks(small("cornell", 8, 1)); }
    static inline std::vector<AccelSettings> walks_;
};

TEST_P(EveryStructure, HasTheBitsOfTheIterativeLab) {
    const Scene scene = small(GetParam(), 24, 7);
    const Traced expected = trace("02", scene, {}, 2);
    for (const AccelSettings& accel : walks_) {
        const MachineSettings machine{.threads = 1, .wavefront = {.pool = 333}, .accel = accel};
        const Traced traced = trace("04", scene, machine, 2);
        ASSERT_EQ(first_difference(traced, expected, scene.camera.width), "")
            << name_of(accel.accel) << ", " << name_of(accel.walk);
        ASSERT_TRUE(same_bits(traced.film, expected.film))
            << name_of(accel.accel) << ", " << name_of(accel.walk);
    }
}

// A structure and the walks that belong to it are really there.
TEST(Structures, AreThere) {
    const std::vector<AccelSettings> walks = all_walks(small("cornell", 8, 1));
    for (const AccelSettings& accel : {AccelSettings{}, AccelSettings{AccelKind::none},
                                       AccelSettings{AccelKind::kd, WalkKind::stack},
                                       AccelSettings{AccelKind::kd, WalkKind::ropes},
                                       AccelSettings{AccelKind::kd, WalkKind::restart},
                                       AccelSettings{AccelKind::sah, WalkKind::stack},
                                       AccelSettings{AccelKind::sah, WalkKind::skip},
                                       AccelSettings{AccelKind::sah, WalkKind::parent},
                                       AccelSettings{AccelKind::sah, WalkKind::trail},
                                       AccelSettings{AccelKind::wide, WalkKind::stack},
                                       AccelSettings{AccelKind::wide, WalkKind::trail}})
        EXPECT_NE(std::find(walks.begin(), walks.end(), accel), walks.end())
            << name_of(accel.accel) << ", " << name_of(accel.walk);
}

INSTANTIATE_TEST_SUITE_P(Bundled, EveryStructure, testing::ValuesIn(bundled_scenes()),
                         [](const auto& info) { return info.param; });

} // namespace

} // namespace raylab::app
