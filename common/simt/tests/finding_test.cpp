// Findings as lines of JSON and back, folded, and read from the engine's reports.
#include "common/simt/finding.h"

#include "common/simt/engine/findings.h"

#include <gtest/gtest.h>

namespace raylab::simt {

namespace {

Finding race() {
    Finding finding;
    finding.kind = "race";
    finding.severity = Severity::warning;
    finding.place = {"a b.cu", 8, 5};
    finding.message = "said \"so\"\nand so";
    finding.advice = "add __syncthreads()";
    finding.actor = {"k<4>", Index3{1, 2, 3}, Index3{4, 5, 6}};
    finding.other = {{"c.cu", 9, 0}, "write", {"k<4>", Index3{0, 0, 0}, {}}};
    finding.count = 3;
    finding.mode = "races";
    return finding;
}

TEST(Finding, SurvivesItsLine) {
    const std::string line = to_json_line(race());
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const FindingsFile file = parse_findings(line + "\n" + to_json_line(RunSummary{1, 2, 3, 4}));
    ASSERT_EQ(file.findings.size(), 1u);
    EXPECT_EQ(to_json_line(file.findings[0]), line);
    ASSERT_TRUE(file.summary);
    EXPECT_EQ(file.summary->bytes, 4u);
}

TEST(Finding, LinesThatAreCutOffArePassedOver) {
    const std::string line = to_json_line(race());
    const FindingsFile file = parse_findings("{}\n[1]\n{\"kind\":7}\n" + line.substr(0, 40));
    EXPECT_TRUE(file.findings.empty());
    EXPECT_FALSE(file.summary);
}

TEST(Finding, FoldsByKindAndBothPlaces) {
    Finding elsewhere = race(), alone = race();
    elsewhere.other->place.line = 10;
    alone.other.reset();
    const auto kept = folded({race(), elsewhere, race(), alone});
    ASSERT_EQ(kept.size(), 3u);
    EXPECT_EQ(kept[0].count, 6);
    EXPECT_EQ(kept[1].other->place.line, 10);
    EXPECT_FALSE(kept[2].other);
}

TEST(Finding, ReportsOfTheEngineAreRead) {
    const Finding finding = finding_of_report(
        "f.cu:41: error: divergent barrier: the threads wait\n"
        "  kernel k<2>, launched at f.cu:60, grid (1,1,1), block size (64,1,1)\n"
        "  block (7,0,0), thread (3,0,0)\n"
        "  f.cu:41: 48 threads wait at __syncthreads(), the first is thread (3,0,0)\n"
        "  f.cu:44: 16 threads wait at __syncthreads(), the first is thread (9,0,0)\n"
        "  expected: all reach the same\n  to do: move the barrier");
    EXPECT_EQ(finding.kind, "divergent-barrier");
    EXPECT_EQ(finding.place, (SourcePlace{"f.cu", 41, 0}));
    EXPECT_EQ(finding.message, "divergent barrier: the threads wait");
    EXPECT_EQ(finding.advice, "move the barrier");
    EXPECT_EQ(finding.actor.kernel, "k<2>");
    EXPECT_EQ(finding.actor.block, (Index3{7, 0, 0}));
    EXPECT_EQ(finding.actor.thread, (Index3{3, 0, 0}));
    ASSERT_TRUE(finding.other);
    EXPECT_EQ(finding.other->place.line, 44);
    EXPECT_EQ(finding.other->what, "16 threads wait at __syncthreads()");
    EXPECT_EQ(finding.other->actor.thread, (Index3{9, 0, 0}));
}

} // namespace

} // namespace raylab::simt
