// The lab's files are found wherever a student has put them, and no others.
#include "grader/submissions/pick.h"
#include "grader/submissions/submission_error.h"
#include "grader/submissions/tests/fake_sheet.h"

#include <gmock/gmock.h>

namespace raylab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<Item> items_of(const std::vector<std::string>& names) {
    std::vector<Item> items;
    for (const std::string& name : names) items.push_back(item_named(name, {}));
    return items;
}

// Where each picked file was found.
std::vector<std::string> found_in(const std::vector<std::string>& names) {
    std::vector<std::string> found;
    for (const Picked::File& file : pick_files(items_of(names), fake_sheet()).files)
        found.push_back(file.item.name);
    return found;
}

TEST(Pick, FindsTheFilesInAnyFolder) {
    EXPECT_THAT(found_in({"path.h", "renderer.cu"}), ElementsAre("path.h", "renderer.cu"));
    EXPECT_THAT(found_in({"my lab/path.h", "my lab/kd/split.cpp"}),
                ElementsAre("my lab/path.h", "my lab/kd/split.cpp"));
    EXPECT_THAT(found_in({"raylab/labs/02_iterative/path.h", "raylab/README.md"}),
                ElementsAre("raylab/labs/02_iterative/path.h"));
}

TEST(Pick, TakesTheLabsOwnFolderBeforeOthers) {
    // Another lab and another part of the tree have files of the same name.
    EXPECT_THAT(found_in({"labs/03_wavefront/path.h", "labs/03_wavefront/renderer.cu",
                          "labs/02_iterative/path.h", "common/x/path.h"}),
                ElementsAre("labs/02_iterative/path.h"));
    EXPECT_THAT(found_in({"labs/03_wavefront/path.h"}), IsEmpty());
    EXPECT_THAT(found_in({"old/path.h", "new/path.h", "new/renderer.cu"}),
                ElementsAre("new/path.h", "new/renderer.cu"));                 // the most files
    EXPECT_THAT(found_in({"path.h", "backup/path.h"}), ElementsAre("path.h")); // the shallowest
    EXPECT_THAT(found_in({"__MACOSX/._path.h", "__MACOSX/path.h", "build/x/path.h", "a/path.h"}),
                ElementsAre("a/path.h"));
}

TEST(Pick, TwoFoldersAlikeAreRefused) {
    try {
        found_in({"a/path.h", "b/path.h"});
        FAIL() << "no error";
    } catch (const SubmissionError& error) {
        EXPECT_THAT(error.what(), HasSubstr("'a/' and 'b/'"));
    }
}

TEST(Pick, NamesWhatIsMissingAndWhatIsIgnored) {
    std::vector<Item> items = items_of({"path.h", "notes.txt", ".DS_Store", "a.out"});
    const Picked picked = pick_files(items, fake_sheet());
    EXPECT_THAT(picked.missing, ElementsAre("renderer.cu", "kd/split.cpp"));
    EXPECT_THAT(picked.ignored, ElementsAre("notes.txt", "a.out"));
    items.push_back(item_named("renderer.cu", {}));
    items.back().kind = Item::Kind::link;
    EXPECT_THAT(pick_files(items, fake_sheet()).missing,
                ElementsAre("renderer.cu (a link is not followed)", "kd/split.cpp"));
}

TEST(Pick, AHostileNameRefusesAll) {
    EXPECT_THROW(found_in({"path.h", "../../labs/02_iterative/path.h"}), SubmissionError);
    EXPECT_THROW(found_in({"path.h", "x\ny"}), SubmissionError);
}

TEST(Pick, NamesThatOnlyEndAlikeAreOthers) {
    EXPECT_THAT(found_in({"mypath.h", "a/split.cpp", "path.hpp", "Path.h"}), IsEmpty());
    EXPECT_TRUE(could_be_of_lab("x/kd/split.cpp", fake_sheet()));
    EXPECT_FALSE(could_be_of_lab("x/split.cpp", fake_sheet()));
    EXPECT_FALSE(could_be_of_lab("labs/03_wavefront/path.h", fake_sheet()));
}

} // namespace
} // namespace raylab
