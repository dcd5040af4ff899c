// The picture shows what was counted by hand.
#include "grader/report/lanes.h"

#include <gmock/gmock.h>

#include <array>

namespace raylab {
namespace {

int count(const std::string& text, const std::string& word) {
    int n = 0;
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++n;
    return n;
}

TEST(LanesPicture, CellsAndSharesAreThoseOfThePaths) {
    Ledger ledger;
    ledger.lab = "02_iterative", ledger.scene = "a<b", ledger.samples = 4;
    ledger.bounces.resize(4);
    for (int bounce = 0; bounce < 3; ++bounce) {
        ledger.bounces[bounce].rays = std::uint64_t(3 - bounce);
        ledger.bounces[bounce].lanes = 32;
    }
    std::array<PathRecord, 3> warp;
    warp[0].length = 3, warp[1].length = 1, warp[2].length = 2;
    const std::string picture = lanes_picture(ledger, warp, 64);
    EXPECT_THAT(picture, testing::StartsWith("<svg xmlns="));
    EXPECT_THAT(picture, testing::HasSubstr("Pixels 64 to 66 as one warp"));
    EXPECT_THAT(picture, testing::HasSubstr("6 of 9 lane-bounces at work, 33 % wasted"));
    EXPECT_THAT(picture, testing::HasSubstr("a&lt;b"));
    EXPECT_THAT(picture, testing::HasSubstr("9.4 %   3 of 32"));
    EXPECT_THAT(picture, testing::HasSubstr("bounce 2"));
    EXPECT_THAT(picture, testing::Not(testing::HasSubstr("bounce 3"))); // no ray
    // A cell is 14 wide: 6 traced; done after 1 and after 2 rays; 1 more is wasted.
    EXPECT_EQ(count(picture, "width=\"14.0\" height=\"17\" fill=\"#2a78b8\""), 6);
    EXPECT_EQ(count(picture, "width=\"14.0\" height=\"17\" fill=\"#f2c14e\""), 2);
    EXPECT_EQ(count(picture, "width=\"14.0\" height=\"17\" fill=\"#e4e4e4\""), 1);
}

TEST(LanesPicture, WithoutPathsIsAPictureStill) {
    EXPECT_THAT(lanes_picture({}, {}, 0), testing::EndsWith("</svg>\n"));
}

} // namespace
} // namespace raylab
