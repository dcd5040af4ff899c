// Safe files: complete or absent, and every failure says what to do.
#include "common/cli/files.h"

#include "common/cli/tests/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

#include <sys/resource.h>
#include <unistd.h>

namespace raylab {
namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;

class Files : public testing::Test {
  protected:
    void SetUp() override { fs::permissions(folder, fs::perms::all); }

    std::size_t entries() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }
    std::string in(const char* name) const { return (folder / name).string(); }

    TemporaryFolder temporary;
    const fs::path folder = temporary.path();
};

template <class Action> std::string error_of(Action action) {
    try {
        action();
    } catch (const FileError& e) {
        return e.what();
    }
    return "no error";
}

TEST_F(Files, BytesComeBackAsTheyWere) {
    std::string bytes("\0\n\r\xff", 4);
    bytes.append(300000, 'x');
    write_file(in("a"), bytes);
    EXPECT_EQ(read_file(in("a")), bytes);
    write_file(in("a"), "shorter");
    EXPECT_EQ(read_file(in("a")), "shorter");
    EXPECT_EQ(entries(), 1u) << "a temporary file was left behind";
}

TEST_F(Files, ASymbolicLinkStaysALink) {
    write_file(in("target"), "old");
    fs::create_symlink("target", folder / "link");
    write_file(in("link"), "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(read_file(in("target")), "new");
}

TEST_F(Files, AWriteThatFailsHalfwayLeavesTheOldFileAndNothingElse) {
    write_file(in("a"), "old");
    struct rlimit before;
    getrlimit(RLIMIT_FSIZE, &before);
    const struct rlimit tight { 100000, before.rlim_max };
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &tight);
    const std::string error = error_of([&] { write_file(in("a"), std::string(200000, 'x')); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_THAT(error, HasSubstr("larger than is allowed"));
    EXPECT_EQ(read_file(in("a")), "old");
    EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, AFullDiskIsSaid) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    EXPECT_THAT(error_of([] { write_file("/dev/full", "x"); }), HasSubstr("disk is full"));
    EXPECT_TRUE(fs::is_character_file("/dev/full")) << "the device was replaced by a file";
}

TEST_F(Files, AReadOnlyFolderIsSaid) {
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                                fs::perms::others_exec);
    // The superuser may write anywhere, so the test becomes the user `nobody` for a moment.
    const bool root = geteuid() == 0;
    if (root) {
        ASSERT_EQ(seteuid(65534), 0);
    }
    const std::string error = error_of([&] { write_file(in("a"), "x"); });
    if (root) {
        ASSERT_EQ(seteuid(0), 0);
    }
    fs::permissions(folder, fs::perms::all);
    EXPECT_THAT(error, HasSubstr("no permission"));
    EXPECT_THAT(error, HasSubstr(folder.string()));
    EXPECT_EQ(entries(), 0u);
}

// The longest name that a file can have still leaves room for the temporary one.
TEST_F(Files, LongNames) {
    write_file(in(std::string(255, 'x').c_str()), "1");
    EXPECT_EQ(entries(), 1u);
    const std::string too_long = in(std::string(300, 'x').c_str());
    EXPECT_THAT(error_of([&] { write_file(too_long, "x"); }), HasSubstr("name is too long"));
    EXPECT_THAT(error_of([&] { prepare_output(too_long); }), HasSubstr("name is too long"));
    EXPECT_THAT(error_of([&] { prepare_output(too_long + "/a"); }), HasSubstr("name is too long"));
    EXPECT_THAT(error_of([&] { read_file(too_long); }), HasSubstr("name is too long"));
}

TEST_F(Files, AnOutputIsTriedBeforeTheWork) {
    prepare_output(in("new/folder/a"));
    EXPECT_TRUE(fs::is_directory(folder / "new/folder"));
    EXPECT_TRUE(fs::is_empty(folder / "new/folder"));
    write_file(in("file"), "1");
    EXPECT_THAT(error_of([&] { prepare_output(in("file/a")); }), HasSubstr("is not a folder"));
    EXPECT_THAT(error_of([&] { prepare_output(in("new")); }), HasSubstr("is a folder"));
    EXPECT_THAT(error_of([] { prepare_output("/proc/a"); }),
                HasSubstr("the folder '/proc' takes no new files"));
    EXPECT_EQ(error_of([] { prepare_output("/dev/null"); }), "no error");
    EXPECT_EQ(read_file(in("file")), "1");
}

TEST_F(Files, ThePersonsErrorsAndTheMachinesAreToldApart) {
    const auto code_of = [](auto action) {
        try {
            action();
        } catch (const FileError& error) {
            return error.code;
        }
        return ExitCode::success;
    };
    EXPECT_EQ(code_of([&] { read_file(in("none")); }), ExitCode::bad_usage);
    EXPECT_EQ(code_of([] { prepare_output("/proc/a"); }), ExitCode::bad_usage);
    EXPECT_EQ(code_of([] { write_file("/dev/full", "x"); }), ExitCode::tool_failed);
}

// Exceptions of std::filesystem, from calls that were not asked for an error code.
TEST_F(Files, FilesystemErrorsAreTranslated) {
    try {
        fs::create_directories(in("a/b"));
        write_file(in("a/b/c"), "1");
        fs::remove(folder / "a");
        FAIL() << "a folder that is not empty was removed";
    } catch (const fs::filesystem_error& error) {
        const std::string said = file_error(error).what();
        EXPECT_THAT(said, HasSubstr(in("a")));
        EXPECT_THAT(said, HasSubstr("not empty"));
        EXPECT_THAT(said, testing::Not(HasSubstr("filesystem error")));
    }
}

TEST(EndingOf, IsInLowerCase) {
    EXPECT_EQ(ending_of("a.b/X.PnG"), ".png");
    EXPECT_EQ(ending_of("a.b/x"), "");
    EXPECT_EQ(ending_of(".exr"), "");
}

TEST_F(Files, MissingThingsAreSaid) {
    EXPECT_THAT(error_of([&] { write_file(in("no/such/file"), "x"); }), HasSubstr("no folder"));
    EXPECT_THAT(error_of([&] { write_file(folder.string(), "x"); }), HasSubstr("is a folder"));
    EXPECT_THAT(error_of([&] { write_file("", "x"); }), HasSubstr("without a name"));
    EXPECT_THAT(error_of([&] { read_file(in("a")); }), HasSubstr("no such file"));
    EXPECT_THAT(error_of([&] { read_file(folder.string()); }), HasSubstr("is a folder"));
}

} // namespace
} // namespace raylab
