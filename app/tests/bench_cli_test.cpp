// raylab bench as a person meets it: a whole small run, and peers that are absent, break or draw
// something else.
#include "app/tests/cli.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace raylab::app {
namespace {

using nlohmann::json;
using testing::AnyOf;
using testing::HasSubstr;

class BenchCli : public Cli {
  protected:
    // A quad under a lamp, in the variant of kernels that is quickest.
    void SetUp() override { write_room("room.json", "0.8"); }

    void write_room(const std::string& name, const std::string& albedo) const {
        write(name, R"({
    "version": 1, "title": "t", "reason": "r",
    "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 40},
    "film": {"width": 32, "height": 32},
    "render": {"max_depth": 4, "spp": 4},
    "materials": {"white": {"kind": "diffuse", "reflectance": [)" +
                        albedo + "," + albedo + "," + albedo + R"(]},
                  "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [4, 4, 4]}},
    "shapes": [{"kind": "quad", "vertices": [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]], "material": "white"},
               {"kind": "quad", "vertices": [[1, 1, 2], [1, 2, 2], [2, 2, 2], [2, 1, 2]], "material": "lamp"}]
})");
    }

    // A script that takes Blender's arguments: `-b ... -- --spp N --seed S --threads T -o F`.
    std::string fake_blender(const std::string& render) const {
        write("blender", "#!/bin/sh\n[ \"$1\" = --version ] && echo Fake 1 && exit 0\n"
                         "while [ \"$1\" != -- ]; do shift; done\n"
                         "spp=$3 seed=$5 output=$9\n" +
                             render + "\n");
        fs::permissions(in("blender"), fs::perms::owner_all);
        return " --peers cycles --blender " + in("blender");
    }

    std::string bench(const std::string& more, const std::string& spp = "4,64") const {
        return "bench " + in("room.json") + " --spp " + spp + " -o " + in("out") + " " + more;
    }

    json row(const std::string& name) const {
        std::ifstream file(in("out/bench.json"));
        const json bench = json::parse(file);
        for (const json& row : bench["scenes"][0]["rows"])
            if (row["name"] == name) return row;
        return {};
    }
};

TEST_F(BenchCli, WritesTableCsvJsonAndPage) {
    const Outcome outcome = raylab(bench("--peers none --labs 01,02"));
    ASSERT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("images are judged against 01_recursive"));
    for (const char* name : {"bench.csv", "bench.json", "bench.html"})
        EXPECT_TRUE(fs::exists(in("out") + "/" + name)) << name;
    const json lab = row("02");
    EXPECT_TRUE(lab["agrees"]);
    EXPECT_EQ(lab["ms_per_spp"]["rounds"].size(), 5u);
    EXPECT_GT(lab["rays_per_second"], 0);
    EXPECT_GT(lab["bytes_per_path"], 56); // the film alone
    EXPECT_EQ(lab["bounces"][0]["paths_share"], 1);

    const Outcome again =
        raylab(bench("--peers none --labs 01,02 --against ") + in("out/bench.json"));
    EXPECT_EQ(again.code, 0) << again.text;
    // On a busy machine so small a scene may have a round without a measurable slope.
    EXPECT_THAT(again.text, AnyOf(HasSubstr("ratios to 01"),
                                  HasSubstr("02: speed not compared, since a round of")));
}

TEST_F(BenchCli, APeerThatIsAbsentOrBreaksIsSaid) {
    EXPECT_THAT(raylab(bench("--labs 02 --peers cycles --blender /no/blender")).text,
                HasSubstr("not here: '/no/blender' could not be started: No such file"));
    EXPECT_THAT(raylab(bench("--labs 02" + fake_blender("echo Error: no memory; exit 3"))).text,
                HasSubstr("at 4 spp: exit status 3: Error: no memory"));
    EXPECT_THAT(raylab(bench("--labs 02" + fake_blender("exit 0"))).text,
                HasSubstr("left no image"));
    EXPECT_TRUE(row("02")["agrees"]);
}

TEST_F(BenchCli, APeerWithAWrongImageGetsNoRatio) {
    write_room("dark.json", "0.7");
    const std::string draw = std::string(RAYLAB_PROGRAM) + " render 02 " + in("");
    const std::string how = " --spp $spp --seed $seed -q -o $output";
    Outcome outcome = raylab(bench("--labs 01" + fake_blender(draw + "dark.json" + how)));
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.text, HasSubstr("images differ"));
    EXPECT_TRUE(row("cycles")["efficiency_ratio"].is_null());
    EXPECT_TRUE(row("cycles")["speed_ratio"].is_null());

    outcome = raylab(bench("--labs 01" + fake_blender(draw + "room.json" + how)));
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_FALSE(row("cycles")["efficiency_ratio"].is_null());
}

TEST_F(BenchCli, WrongUsageIsRefusedBeforeTheWork) {
    expect_refused(bench("--peers none", "4"), {"--spp", "two different"});
    expect_refused(bench("--peers none", "4,4"), {"--spp", "two different"});
    expect_refused(bench("--peers none --repeats 3"), {"--repeats"});
    expect_refused(bench("--peers pov"), {"no peer 'pov'", "mitsuba_llvm"});
    expect_refused(bench("--peers none --labs 77"), {"no lab '77'"});
    expect_refused(bench("--peers none --baseline cycles"), {"--baseline 'cycles'"});
    expect_refused(bench("--peers none --size 12"), {"--size '12'", "512x512"});
    expect_refused(bench("--peers none --size 0x5"), {"width"});
    write("other.json", "{\"kind\": 1}");
    expect_refused(bench("--peers none --against ") + in("other.json"), {"other.json", "/kind"});
    EXPECT_FALSE(fs::exists(in("out/bench.json")));
}

TEST_F(BenchCli, ASceneThatAPeerCannotDrawIsSaid) {
    write_scene("sky.json");
    const Outcome outcome = raylab("bench " + in("sky.json") + " --labs 02 --spp 4,64 -o " +
                                   in("out") + fake_blender("exit 0"));
    EXPECT_THAT(outcome.text, HasSubstr("cannot be written for Blender Cycles: the export has no "
                                        "environment light"));
}

} // namespace
} // namespace raylab::app
