// Where outputs may go, as a person meets it: what cannot be written is refused before the work,
// what fails at the end is said in one sentence and leaves nothing behind.
#include "app/tests/cli.h"

#include <gmock/gmock.h>

namespace raylab::app {
namespace {

using testing::HasSubstr;
using testing::Not;

class OutputCli : public Cli {
  protected:
    void SetUp() override {
        write_scene("s.json");
        write("file", "a file, not a folder");
    }

    // A render that would take hours: if a wrong name were found only afterwards, the test would
    // not end in time.
    std::string long_render(const std::string& more) const {
        return "render 01 " + in("s.json") + " --spp 1000000 " + more;
    }

    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder))
            names.push_back(entry.path().filename().string());
        return names;
    }
};

Outcome soon(const std::string& arguments) {
    return run_in_shell("timeout 20 " + std::string(RAYLAB_PROGRAM) + " " + arguments);
}

TEST_F(OutputCli, WrongPlacesAreRefusedBeforeTheWork) {
    const std::string long_name(300, 'x'), wrong_scene = in("s.json");
    const struct {
        std::string arguments, words;
    } cases[] = {
        {long_render("-o " + in("file/o.exr")), "is not a folder"},
        {long_render("-o " + in(long_name + ".exr")), "name is too long"},
        {long_render("-o " + in(long_name + "/o.exr")), "name is too long"},
        {long_render("-o /proc/o.exr"), "the folder '/proc' takes no new files"},
        {long_render("-o /proc/raylab/o.exr"), "/proc"},
        {long_render("-o " + in("o.exr") + " --stats " + folder.string()), "is a folder"},
        {long_render("-o " + in("o.exr") + " --stats " + in("file/l.json")), "is not a folder"},
        {long_render("--snapshots 1,2 -o " + in(std::string(249, 'x') + ".exr")),
         "name is too long"},
        {"reference cornell --spp 1000000 -o " + in("file"), "is not a folder"},
        {"demo -o " + in("file"), "is not a folder"},
        {"bench cornell --peers none -o " + in("file"), "is not a folder"},
        {"bench cornell --peers none -o " + in(long_name), "name is too long"},
        {"bench-rays terrain:1000 -o " + in("file/a"), "is not a folder"},
        {"bench-rays " + long_name + ":100", "mesh '" + long_name},
        {"compare a.exr b.exr -o " + in("file"), "is not a folder"},
        {"export cornell --mitsuba -q -o " + in("file"), "is not a folder"},
        {"bench cornell --peers none -o " + in("out") + " --against " + in(long_name),
         "name is too long"},
        {"render 02 " + long_name, "there is no scene"},
    };
    for (const auto& wrong : cases) {
        const Outcome outcome = soon(wrong.arguments);
        EXPECT_EQ(outcome.code, 2) << wrong.arguments << "\n" << outcome.text;
        EXPECT_THAT(outcome.text, HasSubstr(wrong.words)) << wrong.arguments;
        EXPECT_THAT(outcome.text, Not(HasSubstr("filesystem error"))) << wrong.arguments;
    }
    EXPECT_THAT(names(), testing::UnorderedElementsAre("file", "s.json", "out"));
}

TEST_F(OutputCli, AFileSizeLimitIsSaidAndLeavesNothing) {
    const Outcome outcome =
        run_in_shell("ulimit -f 8; " + std::string(RAYLAB_PROGRAM) + " render 01 " + in("s.json") +
                     " -q --spp 2 --width 64 --height 64 -o " + in("o.exr"));
    EXPECT_EQ(outcome.code, 3) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("o.exr': the file would be larger than is allowed here"));
    EXPECT_THAT(names(), testing::UnorderedElementsAre("file", "s.json"));
}

TEST_F(OutputCli, AFullDiskIsTheMachinesTrouble) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    fs::create_symlink("/dev/full", folder / "full.exr");
    const Outcome outcome = soon("render 01 " + in("s.json") + " -q -o " + in("full.exr"));
    EXPECT_EQ(outcome.code, 3) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("full.exr': the disk is full"));
}

TEST_F(OutputCli, EndingsMayBeInCapitals) {
    for (const std::string name : {"a.PNG", "a.Exr", "a.HDR", "a.pFm"}) {
        const Outcome outcome = soon("render 01 " + in("s.json") + " -q -o " + in(name));
        EXPECT_EQ(outcome.code, 0) << outcome.text;
        EXPECT_TRUE(fs::exists(in(name)));
    }
    EXPECT_EQ(soon("compare " + in("a.Exr") + " " + in("a.Exr")).code, 0);
    write("M.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Outcome rays = soon("bench-rays " + in("M.OBJ") +
                              " --structures brute --size 8x8 --verify 0 -o " + in("rays"));
    EXPECT_EQ(rays.code, 0) << rays.text;
}

} // namespace
} // namespace raylab::app
