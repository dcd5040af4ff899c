// Exports as the platforms make them: who has sent what.
#include "common/cli/files.h"
#include "common/cli/tests/temporary_folder.h"
#include "grader/submissions/class_export.h"
#include "grader/submissions/gradescope_metadata.h"
#include "grader/submissions/submission.h"
#include "grader/submissions/tests/fake_sheet.h"
#include "grader/submissions/tests/made_archive.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace raylab {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* metadata = "---\n"
                                 "submission_7:\n"
                                 "  :submitters:\n"
                                 "  - :name: Ada Lovelace\n"
                                 "    :sid: '1815'\n"
                                 "    :email: ada@example.edu\n"
                                 "  :created_at: 2026-11-20 12:00:00 Z\n"
                                 "  :history:\n"
                                 "  - :id: 5\n"
                                 "    :name: nobody\n"
                                 "submission_8:\n"
                                 "  :submitters:\n"
                                 "  - :name: 'Ben O''Hara'\n"
                                 "    :sid: ''\n"
                                 "    :email: ben@example.edu\n"
                                 "  - :name: \"C \\\"X\\\" D\"\n"
                                 "    :sid: '3'\n";

// "id(student, student)late: file, file" of each entry.
std::vector<std::string> told(const ClassExport& all) {
    std::vector<std::string> entries;
    for (const ClassEntry& entry : all.entries) {
        std::vector<std::string> students, items;
        for (const Student& student : entry.students)
            students.push_back(student.id + "=" + student.name);
        for (const Item& item : entry.items) items.push_back(item.name);
        std::sort(items.begin(), items.end());
        entries.push_back(fmt::format("{}({}){}: {}", entry.id, fmt::join(students, ", "),
                                      entry.late ? "late" : "", fmt::join(items, ", ")));
    }
    std::sort(entries.begin(), entries.end());
    return entries;
}

ClassExport grouped(const std::vector<std::string>& names, bool packed = false) {
    std::vector<Item> items;
    for (const std::string& name : names) {
        items.push_back(item_named(name, {}));
        if (name.ends_with("/")) items.back().kind = Item::Kind::folder;
    }
    return group_class(items, metadata, packed);
}

TEST(Gradescope, FoldersHaveTheirStudentsInAFile) {
    for (const std::string in : {"", "assignment_1_export/"}) {
        const ClassExport all = grouped({in + "submission_metadata.yml", in + "submission_7/path.h",
                                         in + "submission_7/sub/renderer.cu",
                                         in + "submission_9/path.h", in + "x.txt"});
        EXPECT_EQ(all.layout, "Gradescope");
        EXPECT_THAT(told(all),
                    ElementsAre("submission_7(1815=Ada Lovelace): path.h, sub/renderer.cu",
                                "submission_8(=Ben O'Hara, 3=C \"X\" D): ",
                                "submission_9(submission_9=): path.h"));
        EXPECT_THAT(all.unused, ElementsAre("x.txt"));
    }
}

TEST(Gradescope, ItsFileIsReadWhateverItHolds) {
    EXPECT_THAT(read_gradescope_metadata("\n- :name: x\nsubmission_1:\n:sid: 4\n\xFF\n"),
                testing::SizeIs(1));
    const auto students = read_gradescope_metadata(metadata);
    EXPECT_EQ(students.at("submission_7").at(0).email, "ada@example.edu");
    EXPECT_EQ(students.at("submission_7").size(), 1u); // the history has a name, too
}

TEST(Moodle, FoldersAndFilesAreNamedAlike) {
    EXPECT_THAT(told(grouped({"Ada Lovelace_11_assignsubmission_file/path.h",
                              "Ada Lovelace_11_assignsubmission_onlinetext/onlinetext.html",
                              "\xC3\x9Cnal_Can_12_assignsubmission_file_/a b/path.h",
                              "Nobody_13_assignsubmission_file/"})),
                ElementsAre("11(11=Ada Lovelace): onlinetext.html, path.h",
                            "12(12=\xC3\x9Cnal_Can): a b/path.h", "13(13=Nobody): "));
    const ClassExport flat =
        grouped({"Ada Lovelace_11_assignsubmission_file_path.h",
                 "Ada Lovelace_11_assignsubmission_file_renderer.cu", "stray"});
    EXPECT_EQ(flat.layout, "Moodle");
    EXPECT_THAT(told(flat), ElementsAre("11(11=Ada Lovelace): path.h, renderer.cu"));
    EXPECT_THAT(flat.unused, ElementsAre("stray"));
}

TEST(Canvas, NamesHaveNumbersAndLateness) {
    const ClassExport all = grouped(
        {"lovelaceada_21_900_path.h", "lovelaceada_21_901_path-1.h", "lovelaceada_21_902_path-2.h",
         "lovelaceada_21_903_my-work.zip", "obrien_LATE_22_904_work.tar.gz"});
    EXPECT_EQ(all.layout, "Canvas");
    EXPECT_THAT(told(all), ElementsAre("21(21=lovelaceada): my-work.zip, path.h",
                                       "22(22=obrien)late: work.tar.gz"));
    EXPECT_EQ(all.entries[0].tries, 3);
    EXPECT_EQ(all.entries[1].tries, 1);
}

TEST(Classroom50, RepositoriesEndInTheLogin) {
    const ClassExport all = grouped({"scores.csv", "cs-lab2-ada/path.h", "cs-lab2-ada/result.json",
                                     "cs-lab2-x-y/path.h", "cs-lab2-zed/"});
    EXPECT_EQ(all.layout, "Classroom 50");
    EXPECT_THAT(told(all), ElementsAre("ada(ada=ada): path.h, result.json", "x-y(x-y=x-y): path.h",
                                       "zed(zed=zed): "));
}

TEST(Plain, AFolderOrAnArchiveAStudent) {
    const std::vector<std::string> names = {"ada/path.h", "b\xC3\xB6.zip", "c.d.tar.gz",
                                            "e f/",       "list.txt",      "ada.zip"};
    EXPECT_THAT(told(grouped(names)), ElementsAre("ada(ada=ada): ada.zip, path.h",
                                                  "b__(b\xC3\xB6=b\xC3\xB6): b\xC3\xB6.zip",
                                                  "c.d(c.d=c.d): c.d.tar.gz", "e_f(e f=e f): "));
    // Who packs a folder packs its name, too; who names a folder means its content.
    EXPECT_THAT(told(grouped({"subs/ada/path.h", "subs/ben/path.h"}, true)),
                ElementsAre("ada(ada=ada): path.h", "ben(ben=ben): path.h"));
    EXPECT_THAT(told(grouped({"ada/labs/path.h"}, false)),
                ElementsAre("ada(ada=ada): labs/path.h"));
}

TEST(Plain, IdsAreFoldersNamesAndAllDiffer) {
    EXPECT_THAT(told(grouped({"a b/x.h", "a_b/x.h", "a:b/x.h", ".b/x.h"})),
                ElementsAre("_b(.b=.b): x.h", "a_b(a b=a b): x.h", "a_b-2(a_b=a_b): x.h",
                            "a_b-3(a:b=a:b): x.h"));
}

TEST(Plain, AHostileNameIsNobodysOrItsStudents) {
    const ClassExport all =
        grouped({"../x", "/etc/passwd", "ada/path.h", "ada/../../y", "ben/path.h"});
    EXPECT_THAT(all.unused, ElementsAre("../x", "/etc/passwd"));
    EXPECT_THAT(told(all), ElementsAre("ada(ada=ada): ../../y, path.h", "ben(ben=ben): path.h"));
}

TEST(ReadClass, FromAFolderAndFromAnArchiveIsTheSame) {
    const TemporaryFolder folder;
    const fs::path at = folder / "export/submission_7";
    fs::create_directories(at);
    folder.write("export/submission_metadata.yml", metadata);
    folder.write("export/submission_7/path.h", "text");
    folder.write("export/submission_7/big.exr", "x");
    MadeArchive(folder / "export.zip", "zip")
        .file("export/submission_metadata.yml", metadata)
        .file("export/submission_7/path.h", "text")
        .file("export/submission_7/big.exr", "x")
        .close();
    const ClassExport plain = read_class(folder / "export", fake_sheet(), folder / "scratch1");
    const ClassExport packed = read_class(folder / "export.zip", fake_sheet(), folder / "scratch2");
    EXPECT_EQ(told(plain), told(packed));
    for (const ClassExport& all : {plain, packed}) {
        fs::remove_all(folder / "into");
        const Submission one = write_submission(
            read_items(all.entries[0].items, "submission_7", fake_sheet(), folder / "scratch"),
            folder / "into");
        EXPECT_THAT(one.ignored, ElementsAre("big.exr"));
        EXPECT_EQ(read_file((folder / "into/path.h").string()), "text");
    }
}

TEST(ReadClass, ACanvasArchiveKeepsWhatItsNamesEndIn) {
    const TemporaryFolder folder;
    MadeArchive inner(folder / "inner.zip", "zip");
    inner.file("lab/renderer.cu", "inner").close();
    MadeArchive(folder / "submissions.zip", "zip")
        .file("lovelaceada_21_900_path.h", "old")
        .file("lovelaceada_21_901_path-1.h", "new")
        .file("obrien_22_902_work.zip", read_file((folder / "inner.zip").string()))
        .close();
    const ClassExport all =
        read_class(folder / "submissions.zip", fake_sheet(), folder / "scratch");
    ASSERT_EQ(all.entries.size(), 2u);
    const auto text = [&](std::size_t i) {
        return read_items(all.entries[i].items, "x", fake_sheet(), folder / "s").texts.at(0);
    };
    EXPECT_EQ(text(0), "new");
    EXPECT_EQ(text(1), "inner");
}

TEST(ReadClass, NothingToReadIsSaid) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "empty");
    EXPECT_THROW(read_class(folder / "none", fake_sheet(), folder / "s"), SubmissionError);
    EXPECT_THROW(read_class(folder / "empty", fake_sheet(), folder / "s"), SubmissionError);
    folder.write("x.zip", "no archive");
    EXPECT_THROW(read_class(folder / "x.zip", fake_sheet(), folder / "s"), SubmissionError);
}

} // namespace
} // namespace raylab
