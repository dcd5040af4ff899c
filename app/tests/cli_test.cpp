// The program as a person meets it: wrong input gets one clear message, the right exit code, and
// leaves no partial file behind.
#include "app/tests/cli.h"

#include <nlohmann/json.hpp>

namespace raylab::app {
namespace {

TEST_F(Cli, RendersALegalScene) {
    write_scene("s.json");
    for (const std::string lab : {"01", "02", "03", "04"}) {
        const Outcome outcome = raylab("render " + lab + " " + in("s.json") + " -o " + in("o.exr"));
        EXPECT_EQ(outcome.code, 0) << outcome.text;
        EXPECT_TRUE(fs::exists(in("o.exr")));
    }
}

TEST_F(Cli, OnlyTheBuildForGdbStopsAtAPath) {
    write_scene("s.json");
    const Outcome outcome = raylab("debug 02 " + in("s.json") + " --pixel 1,1");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.text, testing::HasSubstr("cannot stop at a path"));
    EXPECT_EQ(raylab("debug 02 " + in("s.json")).code, 2);
}

TEST_F(Cli, ProgressIsNeverWiderThanTheTerminal) {
    const auto render = [&](const std::vector<int>& widths) {
        return run_on_terminal(std::string(RAYLAB_PROGRAM) + " render 02 cornell --spp 100000 -o " +
                                   in("o.exr") + " & sleep 2.5; kill -TERM $!; wait $!",
                               widths);
    };
    for (const int width : {20, 80, 300}) {
        const Outcome outcome = render({width});
        EXPECT_EQ(outcome.code, 143) << outcome.text;
        const int widest = widest_progress(outcome.text);
        EXPECT_GT(widest, 0) << "no progress was shown";
        EXPECT_LT(widest, width);
        if (width == 300) {
            EXPECT_GT(widest, 60) << "facts were cut without need";
        }
    }
    EXPECT_LT(widest_progress(render({30, 12, 7, 12}).text), 30);
}

TEST_F(Cli, WrongScenesAreRefusedWithTheirPlace) {
    const struct {
        std::string from, to;
        std::vector<std::string> words;
    } cases[] = {
        {"\"radius\"",
         "\"raduis\"",
         {"s.json:7:", "/shapes/0", "raduis", "did you mean", "radius"}},
        {"\"radius\": 1", "\"radius\": -1", {"s.json:7:", "/shapes/0/radius"}},
        {"\"radius\": 1", "\"radius\": NaN", {"s.json:7:"}},
        {"\"radius\": 1", "\"radius\": 1e999", {"s.json:7:"}},
        {"\"material\": \"white\"", "\"material\": \"whit\"", {"/shapes/0/material", "white"}},
        {"\"width\": 8, \"height\": 8",
         "\"width\": 0, \"height\": 0",
         {"s.json:4:", "/film/width"}},
        {"\"width\": 8, \"height\": 8", "\"width\": 100000, \"height\": 100000", {"/film/width"}},
        {"\"spp\": 1", "\"spp\": 0", {"s.json:5:", "/render/spp"}},
        {"\"max_depth\": 4", "\"max_depth\": 0", {"s.json:5:", "/render/max_depth"}},
        {"\"up\": [0, 1, 0]", "\"up\": [0, 0, 3]", {"s.json:3:", "/camera/up"}},
        {"\"look_at\": [0, 0, 0]", "\"look_at\": [0, 0, 5]", {"/camera/look_at"}},
        {"\"kind\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 1",
         "\"kind\": \"mesh\", \"file\": \"none.obj\"",
         {"/shapes/0/file", "none.obj"}},
        {"\"version\": 1", "\"version\": 2", {"/version"}},
    };
    for (const auto& wrong : cases) {
        write_scene("s.json", wrong.from, wrong.to);
        expect_refused("render 02 " + in("s.json") + " -o " + in("o.exr"), wrong.words);
    }
}

TEST_F(Cli, TruncatedPicturesAreRefused) {
    write_scene("s.json", R"("kind": "environment", "radiance": [1, 1, 1])",
                R"("kind": "environment", "file": "sky.hdr")");
    write("sky.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 128\n\x02\x02");
    expect_refused("render 02 " + in("s.json") + " -o " + in("o.exr"), {"sky.hdr"});
    write("a.exr", "\x76\x2f\x31\x01 and no more");
    expect_refused("compare " + in("a.exr") + " " + in("a.exr"), {"a.exr"});
    expect_refused("compare " + in("none.exr") + " " + in("a.exr"), {"none.exr"});
}

TEST_F(Cli, OptionsOfThePoolAreForTheLabThatHasOne) {
    write_scene("s.json");
    const std::string scene = " " + in("s.json") + " -o " + in("o.exr");
    const Outcome drawn =
        raylab("render 03" + scene + " --compact 2 --scan warp --sort queues --pool 7 --shuffle 3");
    EXPECT_EQ(drawn.code, 0) << drawn.text;
    fs::remove(in("o.exr"));
    expect_refused("render 02" + scene + " --scan naive", {"lab 02 has no pool of rays", "--scan"});
    expect_refused("render 03" + scene + " --compact never", {"--compact", "never", "off", "on"});
    expect_refused("render 03" + scene + " --pool 0", {"--pool"});
    expect_refused("render 03" + scene + " --first-bounce-cache", {"jitter", "--jitter false"});
    expect_refused("render 03" + scene + " --width 4096 --height 4096 --memory-budget 2",
                   {"film", "2.00 MiB", "--memory-budget"});
}

TEST_F(Cli, OptionsOfTheStructureAreForTheLabThatHasOne) {
    write_scene("s.json");
    const std::string scene = " " + in("s.json") + " -o " + in("o.exr");
    const Outcome drawn = raylab("render 04" + scene + " --accel kd --walk ropes --pool 7");
    EXPECT_EQ(drawn.code, 0) << drawn.text;
    fs::remove(in("o.exr"));
    expect_refused("render 03" + scene + " --accel kd", {"lab 03 has no structure", "--accel"});
    expect_refused("render 02" + scene + " --walk stack", {"lab 02 has no structure", "--walk"});
    expect_refused("render 04" + scene + " --scan naive", {"lab 04", "--scan"});
    expect_refused("render 04" + scene + " --accel octree", {"--accel", "octree", "kd"});
    expect_refused("render 04" + scene + " --accel kd --walk skip",
                   {"no walk 'skip'", "--accel kd", "ropes"});
}

TEST_F(Cli, WrongSettingsOnTheCommandLineAreRefused) {
    write_scene("s.json");
    const std::string render = "render 02 " + in("s.json") + " -o " + in("o.exr");
    expect_refused(render + " --spp 0", {"spp"});
    expect_refused(render + " --depth 0", {"max_depth"});
    expect_refused(render + " --depth 10001", {"max_depth"});
    expect_refused(render + " --width 0", {"width"});
    expect_refused(render + " --width 100000 --height 100000", {"width"});
    expect_refused(render + " --integrator whitted --depth 10000", {"max_depth"});
    expect_refused(render + " --block 2000", {"--block"});
    expect_refused(render + " --sampler halton", {"--sampler"});
    expect_refused(render + " --nonsense", {"--nonsense"});
    expect_refused("render 07 " + in("s.json"), {"no lab '07'", "02_iterative"});
    expect_refused("render 02 cornel -o " + in("o.exr"), {"cornell"});
    expect_refused("render 02 " + in("s.json") + " -o " + in("o.gif"), {".exr"});
    expect_refused("nonsense", {});
    expect_refused("", {});
}

TEST_F(Cli, OddButLegalScenesRender) {
    const struct {
        std::string from, to;
    } cases[] = {
        {R"([{"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "white"}])", "[]"},
        {R"([{"kind": "environment", "radiance": [1, 1, 1]}])", "[]"},
        {"\"radius\": 1", "\"radius\": 9"}, // the camera is inside
        {"\"max_depth\": 4", "\"max_depth\": 10000"},
    };
    for (const auto& odd : cases) {
        write_scene("s.json", odd.from, odd.to);
        for (const std::string lab : {"01", "02"}) {
            const Outcome outcome =
                raylab("render " + lab + " " + in("s.json") + " -o " + in("o.exr"));
            EXPECT_EQ(outcome.code, 0) << odd.to << "\n" << outcome.text;
        }
    }
}

TEST_F(Cli, FullDiskLeavesNoFile) {
    write_scene("s.json");
    const Outcome full =
        raylab("render 02 " + in("s.json") + " -q --stats /dev/full -o " + in("o.exr"));
    EXPECT_EQ(full.code, 3) << full.text;
    EXPECT_NE(full.text.find("/dev/full"), std::string::npos) << full.text;
}

// The superuser may write anywhere, so the folder is one in which not even the superuser may write.
TEST_F(Cli, ReadOnlyPlacesAreRefusedBeforeTheWork) {
    write_scene("s.json");
    const Outcome outcome = raylab("render 02 " + in("s.json") + " -o /proc/raylab/o.exr");
    EXPECT_TRUE(outcome.code == 2 || outcome.code == 3) << outcome.text;
    EXPECT_NE(outcome.text.find("/proc/raylab"), std::string::npos) << outcome.text;
}

TEST_F(Cli, ImagesOfOneSceneAgreeAndOfAnotherDoNot) {
    write_scene("s.json");
    write_scene("t.json", "0.8, 0.8, 0.8", "0.6, 0.8, 0.8");
    raylab("render 02 " + in("s.json") + " --spp 64 -o " + in("a.exr"));
    raylab("render 01 " + in("s.json") + " --spp 64 --seed 2 -o " + in("b.exr"));
    raylab("render 02 " + in("t.json") + " --spp 64 --seed 3 -o " + in("c.exr"));
    EXPECT_EQ(raylab("compare " + in("a.exr") + " " + in("b.exr")).code, 0);
    EXPECT_EQ(raylab("compare " + in("a.exr") + " " + in("c.exr")).code, 1);
}

// Radiance may be of any size that float holds; its square need not.
TEST_F(Cli, ImagesOfAnyBrightnessAreCompared) {
    for (const std::string exponent : {"25", "-22"}) {
        const auto radiance = [&](const std::string& green) {
            return "\"radiance\": [1e" + exponent + ", " + green + "e" + exponent + ", 1e" +
                   exponent + "]";
        };
        write_scene("s.json", "\"radiance\": [1, 1, 1]", radiance("1"));
        write_scene("t.json", "\"radiance\": [1, 1, 1]", radiance("1.5"));
        raylab("render 02 " + in("s.json") + " --spp 64 -o " + in("a.exr"));
        raylab("render 01 " + in("s.json") + " --spp 64 --seed 2 -o " + in("b.exr"));
        raylab("render 02 " + in("t.json") + " --spp 64 --seed 3 -o " + in("c.exr"));
        const Outcome right = raylab("compare " + in("a.exr") + " " + in("b.exr"));
        EXPECT_EQ(right.code, 0) << exponent << "\n" << right.text;
        EXPECT_EQ(raylab("compare " + in("a.exr") + " " + in("c.exr")).code, 1) << exponent;
    }
}

TEST_F(Cli, CompareSaysWhatWouldDecide) {
    write_scene("s.json");
    const auto render = [&](const std::string& options, const std::string& name) {
        EXPECT_EQ(raylab("render 02 " + in("s.json") + " " + options + " -o " + in(name)).code, 0);
    };
    render("--spp 4096", "a.exr");
    render("--spp 1 --seed 2", "one.exr");
    render("--spp 2 --seed 3", "b1.pfm");
    render("--spp 2 --seed 4", "b2.pfm");
    const auto compare = [&](const std::string& words) {
        return raylab("compare " + in("a.exr") + words);
    };
    for (const std::string other : {"one.exr", "b1.pfm"}) {
        const Outcome outcome = compare(" " + in(other));
        EXPECT_EQ(outcome.code, 2) << outcome.text;
        EXPECT_NE(outcome.text.find("raylab compare A1 A2 --with B1 B2"), std::string::npos)
            << outcome.text;
    }
    EXPECT_EQ(compare(" " + in("b1.pfm") + " --exact").code, 1);
    EXPECT_EQ(compare(" --with " + in("b1.pfm") + " " + in("b2.pfm")).code, 0);
    // Replicates must be several images of one size that differ.
    EXPECT_EQ(compare("").code, 2);
    EXPECT_EQ(compare(" " + in("b1.pfm") + " " + in("b2.pfm")).code, 2);
    const Outcome same = compare(" --with " + in("b1.pfm") + " " + in("b1.pfm"));
    EXPECT_EQ(same.code, 2);
    EXPECT_NE(same.text.find("are the same image"), std::string::npos) << same.text;
}

// Its scenes, and its labs, are those of the tree that it was built in.
TEST_F(Cli, AProgramThatWasCopiedDoesNothing) {
    fs::copy_file(RAYLAB_PROGRAM, in("raylab"));
    const Outcome outcome = run_in_shell(in("raylab") + " scenes");
    EXPECT_EQ(outcome.code, 3) << outcome.text;
    EXPECT_NE(outcome.text.find("stands there no more"), std::string::npos) << outcome.text;
}

// The lecture's 1, 20 and 250 iterations come out of one run, and are the images of runs of their
// own.
TEST_F(Cli, SnapshotsAreTheImagesOfShorterRuns) {
    write_scene("s.json");
    const std::string scene = in("s.json");
    raylab("render 02 " + scene + " --spp 20 --snapshots 1,5 -o " + in("run.exr"));
    raylab("render 02 " + scene + " --spp 5 -o " + in("five.exr"));
    ASSERT_TRUE(fs::exists(in("run_0001.exr")) && fs::exists(in("run_0005.exr")));
    const Outcome outcome = raylab("compare --json " + in("run_0005.exr") + " " + in("five.exr"));
    EXPECT_NE(outcome.text.find("\"equal\": true"), std::string::npos) << outcome.text;
}

// Figures that do not depend on the clock.
TEST_F(Cli, RareCasesShowWhereNothingIsGained) {
    const Outcome outcome = raylab("rare-cases --repeats 1 --threads 1 --json 2>/dev/null");
    ASSERT_EQ(outcome.code, 0) << outcome.text;
    const nlohmann::json rows = nlohmann::json::parse(outcome.text);
    ASSERT_EQ(rows.size(), 7u);
    for (const auto& row : rows) {
        const auto& without = row["without"];
        const auto& with = row["with"];
        EXPECT_GT(row["megakernel"]["seconds"], 0) << row["case"];
        EXPECT_DOUBLE_EQ(without["rays"], with["rays"]) << row["case"];
        EXPECT_LE(with["blocks"], without["blocks"]) << row["case"];
    }
    const auto saves_blocks = [&](int i) {
        return rows[i]["with"]["blocks"].get<double>() <
               0.99 * rows[i]["without"]["blocks"].get<double>();
    };
    EXPECT_TRUE(saves_blocks(0)) << "the usual case";
    EXPECT_FALSE(saves_blocks(1)) << "no ray ends";
    EXPECT_FALSE(saves_blocks(3)) << "all end at once";
}

TEST_F(Cli, HelpHasExamplesAndAPipeHasNoProgressLines) {
    for (const std::string command : {"render", "compare", "reference", "scenes", "demo", "bench",
                                      "rare-cases", "export", "import"}) {
        const Outcome outcome = raylab(command + " --help");
        EXPECT_EQ(outcome.code, 0);
        EXPECT_NE(outcome.text.find("Examples"), std::string::npos) << command;
    }
    write_scene("s.json");
    const Outcome outcome = raylab("render 02 " + in("s.json") + " -q --spp 64 -o " + in("o.exr"));
    EXPECT_EQ(outcome.text, "");
}

} // namespace
} // namespace raylab::app
