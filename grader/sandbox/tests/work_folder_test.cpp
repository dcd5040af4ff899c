// What a hostile program leaves in the place of its output.
#include "grader/sandbox/work_folder.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sys/stat.h>

namespace raylab::sandbox {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct ReadOutput : testing::Test {
    WorkFolder work{best_isolation(), 1 << 20, 50};
    void write(const std::string& name, const std::string& bytes) {
        std::ofstream(work.path() / name) << bytes;
    }
    OutputFile read(const std::string& name, std::uint64_t max = 100) {
        return read_output(work.path(), name, max);
    }
};

TEST_F(ReadOutput, ARegularFileIsRead) {
    write("image", "bytes");
    EXPECT_EQ(read("image").bytes, "bytes");
    EXPECT_EQ(read("image").trouble, "");
}

TEST_F(ReadOutput, NothingElseIs) {
    write("image", std::string(101, 'x'));
    EXPECT_THAT(read("image").trouble, HasSubstr("has 101 bytes, and 100 are allowed"));
    EXPECT_THAT(read("none").trouble, HasSubstr("was not written"));
    fs::create_symlink("/etc/passwd", work.path() / "link");
    EXPECT_THAT(read("link", 1 << 20).trouble, HasSubstr("symbolic link"));
    mkfifo((work.path() / "pipe").c_str(), 0600); // open() without O_NONBLOCK would wait forever
    EXPECT_THAT(read("pipe").trouble, HasSubstr("no regular file"));
    fs::create_directory(work.path() / "folder");
    EXPECT_THAT(read("folder").trouble, HasSubstr("no regular file"));
    write("one", "x");
    fs::create_hard_link(work.path() / "one", work.path() / "two");
    EXPECT_THAT(read("two").trouble, HasSubstr("second name"));
    EXPECT_NE(read("../../etc/passwd", 1 << 20).trouble, "");
}

TEST(WorkFolder, GoesAway) {
    fs::path path;
    {
        const WorkFolder work(best_isolation(), 1 << 20, 50);
        path = work.path();
        EXPECT_TRUE(fs::is_directory(path));
    }
    EXPECT_FALSE(fs::exists(path));
}

} // namespace
} // namespace raylab::sandbox
