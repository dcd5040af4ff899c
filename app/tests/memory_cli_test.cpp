// When memory is short, raylab says so before the work, with figures. Where it cannot know that
// before, it ends with one sentence.
#include "app/tests/cli.h"

#include <gmock/gmock.h>

namespace raylab::app {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

class MemoryCli : public Cli {
  protected:
    void SetUp() override {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        GTEST_SKIP() << "sanitizers take more address space than these limits leave";
#endif
        write_scene("s.json");
    }

    Outcome limited(const std::string& mib, const std::string& arguments) const {
        return run_in_shell("ulimit -v $((" + mib + " * 1024)); timeout 60 " RAYLAB_PROGRAM " " +
                            arguments);
    }
};

TEST_F(MemoryCli, AFilmThatDoesNotFitIsRefusedWithWhatWould) {
    for (const std::string lab : {"01", "02", "03", "04"}) {
        const Outcome outcome =
            limited("2000", "render " + lab + " " + in("s.json") +
                                " --width 7680 --height 4320 -o " + in("new/o.exr"));
        EXPECT_EQ(outcome.code, 2) << outcome.text;
        EXPECT_THAT(
            outcome.text,
            MatchesRegex(
                "raylab: a film of 7680 x 4320 pixels takes up to [34].[0-9]* GiB of memory, "
                "1[0-9]* bytes a pixel; 1.[0-9]* GiB are available \\(the limit of "
                "`ulimit -v`\\): --width [0-9]* --height [0-9]* would fit\n"));
        EXPECT_FALSE(fs::exists(in("new")));
    }
}

// The film size that the message names does render.
TEST_F(MemoryCli, TheFilmThatWouldFitRenders) {
    for (const std::string lab : {"01", "02"}) {
        const std::string render =
            "render " + lab + " " + in("s.json") + " --depth 1 -o " + in(lab + ".exr") + " ";
        const Outcome refused = limited("400", render + "--width 4096 --height 4096");
        const std::size_t at = refused.text.find("--width"), end = refused.text.find(" would fit");
        ASSERT_NE(end, refused.text.npos) << refused.text;
        const Outcome fits = limited("400", render + refused.text.substr(at, end - at));
        EXPECT_EQ(fits.code, 0) << fits.text;
        EXPECT_TRUE(fs::exists(in(lab + ".exr")));
    }
}

TEST_F(MemoryCli, MuchIsAnnounced) {
    const Outcome outcome =
        run_in_shell("timeout -s INT --preserve-status 1 " RAYLAB_PROGRAM " render 01 " +
                     in("s.json") + " --width 4096 --height 4096 -o " + in("o.exr"));
    EXPECT_THAT(outcome.text,
                ContainsRegex("01 s: takes up to [1-9].[0-9]* GiB of memory, 116 bytes a pixel"));
}

TEST_F(MemoryCli, WhatCouldNotBeKnownIsASentence) {
    write_scene("large.json", R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1,)",
                R"({"kind": "procedural", "mesh": "terrain", "triangles": 4000000,)");
    const Outcome outcome = limited("300", "render 01 " + in("large.json") + " -o " + in("o.exr"));
    EXPECT_EQ(outcome.code, 3) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("raylab: out of memory: "));
    EXPECT_THAT(outcome.text, HasSubstr("are available now (the limit of `ulimit -v`)"));
    EXPECT_THAT(outcome.text, Not(HasSubstr("bad_alloc")));
}

} // namespace
} // namespace raylab::app
