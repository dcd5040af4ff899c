// From what a student sends to the lab's files alone.
#include "common/cli/files.h"
#include "common/cli/tests/temporary_folder.h"
#include "grader/submissions/source_text.h"
#include "grader/submissions/submission.h"
#include "grader/submissions/tests/fake_sheet.h"
#include "grader/submissions/tests/made_archive.h"

#include <gmock/gmock.h>

#include <sys/stat.h>

namespace raylab {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SubmissionTest : public testing::Test {
  protected:
    Submission unpack(const std::string& from) {
        fs::remove_all(folder_ / "into");
        return unpack_submission(folder_ / from, fake_sheet(), folder_ / "into");
    }
    std::string error_of(const std::string& from) {
        try {
            unpack(from);
        } catch (const SubmissionError& error) {
            EXPECT_FALSE(fs::exists(folder_ / "into"));
            EXPECT_FALSE(fs::exists(folder_ / ".into.part")) << "something was left behind";
            return error.what();
        }
        return "no error";
    }
    std::string text(const std::string& file) {
        return read_file((folder_ / "into" / file).string());
    }
    TemporaryFolder folder_;
};

TEST_F(SubmissionTest, HasTheLabsFilesAlone) {
    MadeArchive(folder_ / "ada.zip", "zip")
        .file("Lab 2/path.h", "a")
        .file("Lab 2/kd/split.cpp", "b")
        .file("Lab 2/notes.txt", "c")
        .file("__MACOSX/Lab 2/._path.h", "junk")
        .close();
    const Submission submission = unpack("ada.zip");
    EXPECT_THAT(submission.files, ElementsAre("path.h", "kd/split.cpp"));
    EXPECT_THAT(submission.missing, ElementsAre("renderer.cu"));
    EXPECT_THAT(submission.ignored, ElementsAre("Lab 2/notes.txt"));
    EXPECT_EQ(text("path.h"), "a");
    EXPECT_EQ(text("kd/split.cpp"), "b");
    EXPECT_FALSE(fs::exists(folder_ / "into/notes.txt"));
    // What was unpacked may be unpacked again, to the same.
    fs::rename(folder_ / "into", folder_ / "again");
    EXPECT_EQ(unpack("again").hash, submission.hash);
}

TEST_F(SubmissionTest, TextIsTheSameWhateverSystemWroteIt) {
    fs::create_directory(folder_ / "windows");
    fs::create_directory(folder_ / "linux");
    folder_.write("windows/path.h", "\xEF\xBB\xBF"
                                    "int a;\r\nint b;\r\n");
    folder_.write("linux/path.h", "int a;\nint b;\n");
    const std::string hash = unpack("windows").hash;
    EXPECT_EQ(text("path.h"), "int a;\nint b;\n");
    EXPECT_EQ(unpack("linux").hash, hash);
    folder_.write("linux/path.h", "int a;\nint c;\n");
    EXPECT_NE(unpack("linux").hash, hash);
    EXPECT_EQ(source_text("a\rb", "x"), "a\nb"); // as Macs wrote it once
}

TEST_F(SubmissionTest, AnArchiveInAFolderIsRead) {
    fs::create_directory(folder_ / "ada");
    MadeArchive(folder_ / "ada/work.tar.gz", "gnutar", "gzip").file("path.h", "a").close();
    folder_.write("ada/letter.pdf", "%PDF");
    const Submission submission = unpack("ada");
    EXPECT_THAT(submission.files, ElementsAre("path.h"));
    EXPECT_THAT(submission.ignored, ElementsAre("letter.pdf"));
    MadeArchive(folder_ / "ada/other.zip", "zip").file("path.h", "b").close();
    EXPECT_THAT(error_of("ada"), HasSubstr("both 'other.zip' and 'work.tar.gz' hold files"));
    folder_.write("ada/path.h", "c"); // sent by itself, it counts
    unpack("ada");
    EXPECT_EQ(text("path.h"), "c");
}

TEST_F(SubmissionTest, OneSourceFileIsASubmission) {
    folder_.write("path.h", "a");
    EXPECT_THAT(unpack("path.h").missing, ElementsAre("renderer.cu", "kd/split.cpp"));
}

TEST_F(SubmissionTest, NothingSentIsSaid) {
    EXPECT_THAT(error_of("nobody"), HasSubstr("there is no submission"));
    fs::create_directory(folder_ / "empty");
    EXPECT_THAT(error_of("empty"), HasSubstr("nothing was sent"));
    folder_.write("empty/.DS_Store", "x");
    EXPECT_THAT(error_of("empty"), HasSubstr("nothing was sent"));
    folder_.write("empty/essay.txt", "x");
    EXPECT_THAT(error_of("empty"), HasSubstr("no file is of the lab; lab 02's files are path.h"));
}

TEST_F(SubmissionTest, HostileOnesAreRefusedAndWriteNothingElsewhere) {
    MadeArchive(folder_ / "slip.tar", "gnutar").file("path.h", "a").file("../evil.h", "b").close();
    EXPECT_THAT(error_of("slip.tar"), HasSubstr("'../evil.h' is not taken: it leads out by '..'"));
    EXPECT_FALSE(fs::exists(folder_ / "evil.h"));
    MadeArchive(folder_ / "link.tar", "gnutar").symlink("path.h", "/etc/passwd").close();
    EXPECT_THAT(error_of("link.tar"), HasSubstr("no file is of the lab"));
    folder_.write("path.h", std::string("a\0b", 3));
    EXPECT_THAT(error_of("path.h"), HasSubstr("zero bytes"));
    folder_.write("path.h", "\xFF\xFE"
                            "a");
    EXPECT_THAT(error_of("path.h"), HasSubstr("UTF-16"));
    folder_.write("path.h", std::string((1 << 20) + 1, 'x'));
    EXPECT_THAT(error_of("path.h"), HasSubstr("more than 1048576 bytes"));
}

TEST_F(SubmissionTest, LinksAndPipesOfAFolderAreNotFollowed) {
    fs::create_directory(folder_ / "ada");
    folder_.write("secret", "secret");
    fs::create_symlink(folder_ / "secret", folder_ / "ada/path.h");
    ASSERT_EQ(mkfifo((folder_ / "ada/renderer.cu").c_str(), 0600), 0);
    EXPECT_THAT(error_of("ada"), HasSubstr("no file is of the lab"));
    EXPECT_THROW(read_sent_file(folder_ / "ada/path.h", "path.h", 100), SubmissionError);
    EXPECT_THROW(read_sent_file(folder_ / "ada/renderer.cu", "x", 100), SubmissionError);
}

TEST_F(SubmissionTest, NothingIsOverwritten) {
    folder_.write("path.h", "a");
    unpack("path.h");
    EXPECT_THROW(unpack_submission(folder_ / "path.h", fake_sheet(), folder_ / "into"), FileError);
    EXPECT_EQ(text("path.h"), "a");
    // What a killed attempt left is no hindrance.
    fs::create_directories(folder_ / ".into.part/files");
    folder_.write(".into.part/files/evil.h", "old");
    EXPECT_THAT(unpack("path.h").files, ElementsAre("path.h"));
    EXPECT_FALSE(fs::exists(folder_ / "into/evil.h"));
}

} // namespace
} // namespace raylab
