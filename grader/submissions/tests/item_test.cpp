// Names as they come, and names that are refused.
#include "common/cli/tests/temporary_folder.h"
#include "grader/submissions/item.h"
#include "grader/submissions/submission_error.h"

#include <gmock/gmock.h>

#include <sys/stat.h>

namespace raylab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Item named(const std::string& raw) { return item_named(raw, {}); }

TEST(ItemName, IsTakenAsItComes) {
    EXPECT_EQ(named("path.h").name, "path.h");
    EXPECT_EQ(named("./my work//lab 2/./path.h").name, "my work/lab 2/path.h");
    EXPECT_EQ(named("my work\\path.h").name, "my work/path.h"); // as old Windows packs
    EXPECT_EQ(named("\xC3\x9C"
                    "bung/path.h")
                  .name,
              "\xC3\x9C"
              "bung/path.h");
    EXPECT_EQ(named("$(reboot)/`x`; <img onerror=1>.h").kind,
              Item::Kind::file); // a name like others
    EXPECT_EQ(named("..path..h").name, "..path..h");
}

TEST(ItemName, IsRefusedIfItLeadsElsewhere) {
    for (const char* name :
         {"../path.h", "a/../../path.h", "a\\..\\..\\path.h", "..", "/etc/passwd",
          "C:\\windows\\path.h", "", "/", "a\nb.h", "a\x1B[31m.h", "a\x7F"})
        EXPECT_EQ(named(name).kind, Item::Kind::hostile) << name;
    EXPECT_EQ(named(std::string(1025, 'x')).kind, Item::Kind::hostile);
    std::string deep;
    for (int i = 0; i < 33; ++i) deep += "d/";
    EXPECT_EQ(named(deep + "x").kind, Item::Kind::hostile);
    EXPECT_THAT(named("a\nb\x1B.h").name, testing::Not(HasSubstr("\n"))); // fit for a message
    EXPECT_THAT(named("../x").why, HasSubstr("'..'"));
}

TEST(Items, OfAFolderAreListedAndLinksNotFollowed) {
    const TemporaryFolder folder, outside;
    outside.write("secret.h", "secret");
    std::filesystem::create_directories(folder / "a/b/c");
    std::filesystem::create_directories(folder / ".git/objects");
    folder.write("a/path.h", "text");
    folder.write("a/b/c/deep.h", "deep");
    folder.write(".git/objects/x", "x");
    std::filesystem::create_symlink(outside / "secret.h", folder / "link.h");
    std::filesystem::create_directory_symlink(outside.path(), folder / "linked");
    ASSERT_EQ(mkfifo((folder / "pipe.h").c_str(), 0600), 0);
    std::vector<std::string> seen;
    for (const Item& item : items_below(folder.path(), {})) {
        const char* kinds[] = {"file", "folder", "link", "special", "hostile"};
        seen.push_back(kinds[static_cast<int>(item.kind)] + (" " + item.name));
    }
    EXPECT_THAT(seen, ElementsAre("folder .git", "folder a", "folder a/b", "file a/b/c/deep.h",
                                  "file a/path.h", "link link.h", "link linked", "special pipe.h"));
}

TEST(Items, TooManyAreRefused) {
    const TemporaryFolder folder;
    for (int i = 0; i < 12; ++i) folder.write(std::to_string(i), "");
    UnpackLimits limits;
    limits.entries = 10;
    EXPECT_THROW(items_below(folder.path(), limits), SubmissionError);
    limits.entries = 12;
    EXPECT_EQ(items_below(folder.path(), limits).size(), 12u);
}

TEST(Names, OfJunkAndArchives) {
    for (const char* name : {"__MACOSX/x/._path.h", "._path.h", "a/.DS_Store", ".git/config",
                             "build/cpu/path.h", "a/__pycache__/x.pyc"})
        EXPECT_TRUE(is_junk(name)) << name;
    for (const char* name : {"path.h", "builder/path.h", "a.build/x", "_path.h"})
        EXPECT_FALSE(is_junk(name)) << name;
    for (const char* name :
         {"a.zip", "A.ZIP", "a.tar", "a.tar.gz", "a.tgz", "a b.tar.xz", "a.tar.zst"})
        EXPECT_TRUE(is_archive_name(name)) << name;
    for (const char* name : {"a.gz", "zip", "a.h", "a.zip.h", "a.7z"})
        EXPECT_FALSE(is_archive_name(name)) << name;
}

} // namespace
} // namespace raylab
