// Archives of every kind are read alike; what is too much ends early.
#include "common/cli/files.h"
#include "common/cli/tests/temporary_folder.h"
#include "grader/submissions/archive.h"
#include "grader/submissions/submission_error.h"
#include "grader/submissions/tests/made_archive.h"

#include <gmock/gmock.h>

namespace raylab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::map<std::string, std::string> texts_in(const std::filesystem::path& file,
                                            const UnpackLimits& limits = {}) {
    std::map<std::string, std::string> texts;
    read_archive(file, "x", limits, [&](const Item& item) -> Sink {
        std::string& text = texts[item.name];
        return [&text](std::string_view bytes) { text += bytes; };
    });
    return texts;
}

std::string error_of(const std::filesystem::path& file, const UnpackLimits& limits = {}) {
    try {
        texts_in(file, limits);
    } catch (const SubmissionError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Archive, OfEveryKindIsReadAlike) {
    const TemporaryFolder folder;
    const std::string umlaut = "\xC3\x9C"
                               "bung/a b.h";
    for (const auto& [format, filter] :
         std::vector<std::pair<const char*, const char*>>{{"zip", ""},
                                                          {"gnutar", ""},
                                                          {"gnutar", "gzip"},
                                                          {"pax", "bzip2"},
                                                          {"pax", "xz"},
                                                          {"gnutar", "zstd"}}) {
        const auto file = folder / "archive";
        MadeArchive(file, format, filter)
            .folder("d")
            .file("path.h", "one")
            .file(umlaut, std::string(100000, 'x'))
            .file("empty", "")
            .close();
        const auto texts = texts_in(file);
        ASSERT_EQ(texts.count(umlaut), 1u) << format << filter;
        EXPECT_EQ(texts.at("path.h"), "one") << format << filter;
        EXPECT_EQ(texts.at(umlaut).size(), 100000u) << format << filter;
        EXPECT_EQ(texts.at("empty"), "");
        EXPECT_EQ(texts.size(), 4u);
    }
}

TEST(Archive, SaysWhatIsNoFile) {
    const TemporaryFolder folder;
    MadeArchive(folder / "a.tar", "gnutar")
        .symlink("path.h", "/etc/passwd")
        .file("x", "x")
        .hardlink("hard", "x")
        .device("null")
        .file("../out", "x")
        .close();
    std::map<std::string, Item::Kind> kinds;
    read_archive(folder / "a.tar", "a.tar", {}, [&](const Item& item) {
        kinds[item.name] = item.kind;
        return nullptr;
    });
    EXPECT_EQ(kinds.at("path.h"), Item::Kind::link);
    EXPECT_EQ(kinds.at("hard"), Item::Kind::link);
    EXPECT_EQ(kinds.at("null"), Item::Kind::special);
    EXPECT_EQ(kinds.at("../out"), Item::Kind::hostile);
}

TEST(Archive, ABombEndsEarly) {
    const TemporaryFolder folder;
    MadeArchive bomb(folder / "bomb.zip", "zip"); // 100 MB of zeros, in 100 KB
    const std::string zeros(5 << 20, '\0');
    for (int i = 0; i < 20; ++i) bomb.file("path" + std::to_string(i) + ".h", zeros);
    bomb.close();
    std::size_t came = 0;
    const auto error = [&](const UnpackLimits& limits) -> std::string {
        came = 0;
        try {
            read_archive(folder / "bomb.zip", "x", limits, [&](const Item&) {
                return [&came](std::string_view bytes) { came += bytes.size(); };
            });
        } catch (const SubmissionError& refused) {
            return refused.what();
        }
        return "no error";
    };
    EXPECT_THAT(error({}), HasSubstr("more than 200 times its size"));
    EXPECT_LT(came, 40u << 20);
    UnpackLimits limits;
    limits.ratio = 1 << 20;
    limits.bytes = 20 << 20;
    EXPECT_THAT(error(limits), HasSubstr("unpacks to more than"));
    EXPECT_LE(came, 20u << 20);
    limits.bytes = 1 << 30;
    limits.taken = 10 << 20;
    EXPECT_THAT(error(limits), HasSubstr("sources and archives have more"));
    EXPECT_LE(came, 10u << 20);
    limits.taken = 1 << 30;
    EXPECT_EQ(error(limits), "no error");
}

TEST(Archive, TooManyFilesAreRefused) {
    const TemporaryFolder folder;
    MadeArchive many(folder / "many.tar", "gnutar");
    for (int i = 0; i < 50; ++i) many.file("f" + std::to_string(i), "");
    many.close();
    UnpackLimits limits;
    limits.entries = 49;
    EXPECT_THAT(error_of(folder / "many.tar", limits), HasSubstr("more than 49 files"));
}

TEST(Archive, ADamagedOneIsRefused) {
    const TemporaryFolder folder;
    MadeArchive(folder / "good.zip", "zip").file("path.h", std::string(50000, 'x') + "y").close();
    const std::string bytes = read_file((folder / "good.zip").string());
    folder.write("cut.zip", bytes.substr(0, 60));
    folder.write("none.zip", "this is no archive");
    folder.write("empty.zip", "");
    for (const char* name : {"cut.zip", "none.zip", "empty.zip"})
        EXPECT_THAT(error_of(folder / name), HasSubstr("damaged, or no zip or tar")) << name;
}

TEST(UnpackedItems, LieUnderNumbers) {
    const TemporaryFolder folder;
    MadeArchive(folder / "a.zip", "zip")
        .file("x/notes.txt", "notes")
        .file("x/path.h", "text")
        .file("__MACOSX/path.h", "junk")
        .close();
    const std::vector<Item> items =
        unpacked_items(folder / "a.zip", "a.zip", folder / "kept", {},
                       [](const Item& item) { return item.name.ends_with("path.h"); });
    ASSERT_EQ(items.size(), 3u);
    EXPECT_TRUE(items[0].path.empty());
    EXPECT_EQ(read_file(items[1].path.string()), "text");
    EXPECT_TRUE(items[2].path.empty());
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "kept"))
        files.push_back(entry.path().filename().string());
    EXPECT_THAT(files, ElementsAre("1"));
}

} // namespace
} // namespace raylab
