// Two runs: what changed, what is noise, and what cannot be compared.
#include "grader/bench/bench.h"
#include "grader/bench/tests/simulated_contestant.h"

#include <gmock/gmock.h>

namespace raylab::bench {
namespace {

using simulated_bench::contestant;
using testing::HasSubstr;

// A run in which contestant "b" takes `seconds` a sample and the machine is `load` times as slow.
nlohmann::json run_with(double seconds, double load, float scale = 1) {
    Bench bench;
    bench.options.baseline = "a";
    bench.options.plan.spp = {16, 64};
    SceneResult scene{"room", "room", "hash", 48, 48, 8, "", {}};
    scene.rows = simulated_bench::rows_of(
        {contestant("a", {load, 0.1 * load}), contestant("b", {load, seconds * load, scale})}, "a");
    bench.scenes = {scene};
    return to_json(bench);
}

const Change& change_of(const Comparison& c, const std::string& who, const std::string& what) {
    for (const Change& change : c.changes)
        if (change.contestant == who && change.quantity == what) return change;
    throw std::runtime_error("no such change");
}

TEST(Against, RatiosOfRatiosDoNotSeeTheLoad) {
    const auto comparison = compare_runs(run_with(0.05, 3), run_with(0.1, 1), "old.json");
    const Change& change = change_of(comparison, "b", "speed");
    EXPECT_EQ(change.formed, "ratios to a");
    EXPECT_EQ(change.verdict, "better");
    EXPECT_NEAR(change.ratio.median, 2, 1e-9);
    // The baseline itself has only seconds, and they say it became slower.
    EXPECT_EQ(change_of(comparison, "a", "speed").formed, "seconds of two runs");
    EXPECT_EQ(change_of(comparison, "a", "speed").verdict, "worse");
}

TEST(Against, TheSameProgramIsNoise) {
    const auto comparison = compare_runs(run_with(0.1, 1), run_with(0.1, 1), "old.json");
    for (const Change& change : comparison.changes)
        EXPECT_EQ(change.verdict, "noise") << change.contestant << " " << change.quantity;
    EXPECT_EQ(comparison.changes.size(), 4u);
}

TEST(Against, AWrongImageIsNotCompared) {
    const auto comparison = compare_runs(run_with(0.01, 1, 0.9f), run_with(0.1, 1), "old.json");
    EXPECT_EQ(comparison.changes.size(), 2u); // of a
    EXPECT_THAT(comparison.notes, testing::ElementsAre(HasSubstr("not right in this run")));
}

TEST(Against, OtherScenesSizesAndBaselinesAreSaid) {
    const nlohmann::json now = run_with(0.1, 1);
    const auto notes_with = [&](const auto& change) {
        nlohmann::json other = now;
        change(other);
        const Comparison comparison = compare_runs(now, other, "old.json");
        return comparison.notes.empty() ? "" : comparison.notes.front();
    };
    EXPECT_THAT(notes_with([](auto& other) { other["scenes"][0]["hash"] = "else"; }),
                HasSubstr("room: not compared, since the scene file is another version"));
    EXPECT_THAT(notes_with([](auto& other) { other["scenes"][0]["width"] = 9; }),
                HasSubstr("its film was 9 x 48 there"));
    EXPECT_THAT(notes_with([](auto& other) { other["spp"] = {1, 2}; }), HasSubstr("2 spp there"));
    EXPECT_THAT(notes_with([](auto& other) { other["scenes"].clear(); }),
                HasSubstr("did not have it"));
    EXPECT_THAT(notes_with([](auto& other) { other["baseline"] = "b"; }),
                HasSubstr("baseline is b, this one's a"));
}

TEST(Against, DamagedFilesAreNamedWithThePlace) {
    const auto said = [](const auto& action) -> std::string {
        try {
            action();
        } catch (const AgainstError& error) {
            return error.what();
        }
        return "nothing";
    };
    EXPECT_THAT(said([] { parse_bench("{", "old.json"); }), HasSubstr("'old.json' is no JSON"));
    EXPECT_THAT(said([] { parse_bench("[1]", "old.json"); }), HasSubstr("/kind"));
    EXPECT_THAT(said([] { parse_bench(R"({"kind": "raylab bench", "version": 9})", "old.json"); }),
                HasSubstr("/version should be 1"));
    nlohmann::json damaged = run_with(0.1, 1);
    damaged["scenes"][0]["rows"][0].erase("ms_per_spp");
    EXPECT_THAT(said([&] { compare_runs(run_with(0.1, 1), damaged, "old.json"); }),
                HasSubstr("'old.json' is damaged"));
}

} // namespace
} // namespace raylab::bench
