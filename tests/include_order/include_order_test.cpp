// Layers point one way, and the page that draws them tells the truth.
#include "tests/include_order/read_includes.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

namespace raylab::order {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::filesystem::path root = RAYLAB_ROOT;

std::vector<std::string> listed_rooms() {
    std::stringstream page;
    page << std::ifstream(root / "docs/architecture.md").rdbuf();
    return rooms_from_the_bottom(page.str());
}

TEST(IncludeOrder, NoIncludePointsUp) {
    EXPECT_THAT(upward(read_includes(root), listed_rooms()), IsEmpty());
}

TEST(IncludeOrder, NoIncludesFormACircle) {
    const Includes includes = read_includes(root);
    EXPECT_GT(includes.size(), 300u); // the tree was found
    EXPECT_THAT(circle(includes), IsEmpty());
}

TEST(IncludeOrder, TheListHasNoRoomThatIsNotThere) {
    for (const std::string& room : listed_rooms())
        EXPECT_TRUE(std::filesystem::is_directory(root / "common" / room)) << room;
}

// What the rules are for.
TEST(IncludeOrder, AnUpwardIncludeIsNamed) {
    const std::vector<std::string> rooms = {"math", "geometry", "scene"};
    const auto wrong = [&rooms](const char* file, const char* other) {
        return upward({{file, {other}}}, rooms);
    };
    EXPECT_THAT(wrong("common/scene/view.h", "common/geometry/ray.h"), IsEmpty());
    EXPECT_THAT(
        wrong("common/geometry/ray.h", "common/scene/view.h"),
        ElementsAre("common/geometry/ray.h includes common/scene/view.h, and common/scene is "
                    "not below common/geometry"));
    EXPECT_THAT(wrong("common/scene/view.h", "labs/01_recursive/path.h"),
                ElementsAre(HasSubstr("labs/01_recursive is not below")));
    EXPECT_THAT(wrong("labs/02_iterative/path.h", "labs/01_recursive/path.h"),
                ElementsAre(HasSubstr("labs/01_recursive is not below labs/02_iterative")));
    EXPECT_THAT(wrong("grader/judge/tiles.h", "app/labs.h"), ElementsAre(HasSubstr("app is not")));
    EXPECT_THAT(wrong("app/main.cpp", "labs/01_recursive/renderer.h"), IsEmpty());
    EXPECT_THAT(wrong("common/attic/old.h", "common/math/vec.h"),
                testing::Contains(HasSubstr("common/attic is not in the list")));
}

TEST(IncludeOrder, ACircleIsNamed) {
    EXPECT_THAT(circle({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b"}}}), ElementsAre("b", "c", "b"));
    EXPECT_THAT(circle({{"a", {"b", "c"}}, {"b", {"c"}}, {"c", {}}}), IsEmpty());
}

} // namespace
} // namespace raylab::order
