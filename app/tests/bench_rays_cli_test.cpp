// raylab bench-rays as a person meets it: whole small runs, and what it refuses.
#include "app/tests/cli.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace raylab::app {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class BenchRaysCli : public Cli {
  protected:
    std::string bench(const std::string& more) const {
        return "bench-rays --structures brute --builds 1 -o " + in("out") + " " + more;
    }

    json result() const {
        std::ifstream file(in("out/rays.json"));
        return json::parse(file);
    }
};

TEST_F(BenchRaysCli, WritesTableCsvJsonAndPage) {
    write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 3 2 4\n");
    const Outcome outcome =
        raylab(bench("cornell terrain:200 " + in("m.obj") + " --size 8x8 --threads 2"));
    ASSERT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("answers against those of brute"));
    EXPECT_THAT(outcome.text, HasSubstr("geometric mean"));
    for (const char* name : {"rays.csv", "rays.json", "rays.html"})
        EXPECT_TRUE(fs::exists(in("out") + "/" + name)) << name;
    const json races = result()["races"];
    ASSERT_EQ(races.size(), 3u);
    EXPECT_EQ(races[1]["mesh"], "terrain:200");
    EXPECT_EQ(races[2]["triangles"], 2);
    for (const json& race : races)
        for (const json& cell : race["rows"][0]["cells"]) {
            EXPECT_EQ(cell["mrays_per_second"]["rounds"].size(), 5u);
            EXPECT_EQ(cell["differing"], 0);
        }
    EXPECT_EQ(races[2]["rows"][0]["cells"][0]["count"], 64);
    EXPECT_EQ(races[2]["rows"][0]["cells"][1]["count"], 64) << "a square that fills the film";
}

TEST_F(BenchRaysCli, GrowthIsMeasuredOverARange) {
    const Outcome outcome =
        raylab(bench("--scaling city --triangles 150..1000 --size 4x4 --rays primary,ao --json"));
    ASSERT_EQ(outcome.code, 0) << outcome.text;
    const json printed = json::parse(outcome.text);
    EXPECT_EQ(printed["scaling"], "city");
    std::vector<std::string> meshes;
    for (const json& race : printed["races"]) meshes.push_back(race["mesh"]);
    EXPECT_EQ(meshes, (std::vector<std::string>{"city:150", "city:300", "city:1000"}));
    EXPECT_EQ(printed["races"][0]["rows"][0]["cells"].size(), 2u);
}

TEST_F(BenchRaysCli, ACameraLooksElsewhere) {
    const auto hits = [&](const std::string& camera) {
        EXPECT_EQ(raylab(bench("terrain:200 --size 8x8 --camera " + camera)).code, 0);
        return result()["races"][0]["rows"][0]["cells"][1]["count"].get<int>();
    };
    EXPECT_EQ(hits("0.5,2,0.5,0.5,3,0.5"), 0);
    EXPECT_EQ(hits("0.5,0.9,0.5,0.5,0,0.5"), 64);
}

// Exit code 0: all contestants give the same answers, those of the labs bit for bit.
TEST_F(BenchRaysCli, AllStructuresAgree) {
    const Outcome outcome = raylab("bench-rays needles:200 city:300 --builds 1 --size 16x16 --rays "
                                   "primary,ao --verify 256 -o " +
                                   in("out"));
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    for (const json& race : result()["races"]) {
        EXPECT_EQ(race["truth"], "brute");
        for (const json& row : race["rows"])
            for (const json& cell : row["cells"]) EXPECT_EQ(cell["differing"], 0) << row["name"];
    }
}

TEST_F(BenchRaysCli, TooManyTestsForBruteForceAreLeftOutWithAWord) {
    const Outcome outcome = raylab(bench("terrain:100000 --size 512x512"));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.text, HasSubstr("nobody can trace terrain:100000: left out"));
}

TEST_F(BenchRaysCli, WrongUsageIsRefusedBeforeTheWork) {
    expect_refused(bench("no_such_scene"), {"there is no scene no_such_scene"});
    expect_refused(bench("/no/mesh.glb"), {"/no/mesh.glb"});
    expect_refused(bench("terain:1000"), {"'terain'", "did you mean \"terrain\"?"});
    expect_refused(bench("terrain:10"), {"'10'", "100 to 4000000"});
    expect_refused(bench("white_furnace"), {"white_furnace has no triangles"});
    expect_refused("bench-rays --structures brut -o " + in("out"),
                   {"--structures 'brut'", "did you mean \"brute\"?"});
    expect_refused(bench("--rays primery"), {"--rays 'primery'", "primary"});
    expect_refused(bench("--size 12"), {"--size '12'", "512x512"});
    expect_refused(bench("--repeats 3"), {"--repeats"});
    expect_refused(bench("--baseline embree"), {"--baseline 'embree'"});
    expect_refused(bench("cornell --camera 1,2,3"), {"--camera"});
    expect_refused(bench("terrain:100 --camera 1,2,3,1,2,3"), {"--camera", "two different points"});
    expect_refused(bench("--scaling terain"), {"--scaling 'terain'", "terrain"});
    expect_refused(bench("cornell --scaling terrain"), {"--scaling makes its own meshes"});
    expect_refused(bench("--scaling terrain --triangles 1000"), {"--triangles '1000'", "range"});
    expect_refused(bench("--scaling terrain --triangles 1000..100"), {"smaller number first"});
    expect_refused(bench("--scaling terrain --triangles 1..1000"), {"100 to 4000000"});
    EXPECT_FALSE(fs::exists(in("out/rays.json")));
}

} // namespace
} // namespace raylab::app
