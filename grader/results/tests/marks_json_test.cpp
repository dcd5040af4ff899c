// marks.json comes back as it was, and what is not one is refused with its place.
#include "grader/results/formats.h"
#include "grader/results/marks_json.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace raylab {
namespace {

using nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;

Mark mark_of(const std::string& id, MarkVerdict verdict, int of_points) {
    Mark mark;
    mark.id = id;
    mark.title = "Task \xC3\xBC " + id;
    mark.verdict = verdict;
    mark.of_points = of_points;
    return mark;
}

Marks example() {
    Marks marks;
    marks.lab = "02_iterative";
    marks.title = "The iterative kernel";
    marks.grader = "raylab 1";
    marks.sandbox = "tier 1: bubblewrap";
    marks.log = "a line\nanother";
    marks.missing = {"path.h"};
    marks.ignored = {"notes.txt", "a \xF0\x9F\x8E\x89.png"};
    marks.seconds = 12.5;
    marks.tasks = {mark_of("2.1", MarkVerdict::pass, 30),
                   mark_of("2.2", MarkVerdict::wrong_image, 15)};
    marks.tasks[1].reasons = {"6.1 sigma too bright", "the likely cause: ..."};
    marks.tasks[1].file = "labs/02_iterative/path.h";
    marks.tasks[1].line = 41;
    marks.tasks[1].read_on = "2.2 The launch";
    marks.tasks[1].seconds = 1.25;
    return marks;
}

std::string error_of(const std::string& text) {
    try {
        read_marks_json(text, "marks.json");
    } catch (const MarksError& error) {
        return error.what();
    }
    return "no error";
}

// The example's file with a change.
std::string changed(const std::function<void(ordered_json&)>& change) {
    ordered_json json = ordered_json::parse(marks_json(example()));
    change(json);
    return json.dump();
}

TEST(MarksJson, ComesBackAsItWas) {
    const std::string text = marks_json(example());
    const Marks marks = read_marks_json(text, "marks.json");
    EXPECT_EQ(marks_json(marks), text);
    EXPECT_EQ(marks.points(), 30);
    EXPECT_EQ(marks.of_points(), 45);
    EXPECT_THAT(marks.missing, ElementsAre("path.h"));
    EXPECT_THAT(marks.tasks[1].reasons,
                ElementsAre("6.1 sigma too bright", "the likely cause: ..."));
    EXPECT_EQ(marks.tasks[1].line, 41);
    EXPECT_EQ(write_marks("marks", example()), text);
}

TEST(MarksJson, KeepsEveryVerdict) {
    Marks marks;
    for (const MarkVerdict verdict : all_verdicts())
        marks.tasks.push_back(mark_of("1", verdict, 5));
    const Marks read = read_marks_json(marks_json(marks), "marks.json");
    ASSERT_EQ(read.tasks.size(), all_verdicts().size());
    for (std::size_t i = 0; i < read.tasks.size(); ++i)
        EXPECT_EQ(read.tasks[i].verdict, all_verdicts()[i]);
    EXPECT_EQ(read.points(), 5);
}

TEST(MarksJson, AnotherVersionIsRefused) {
    EXPECT_THAT(error_of(changed([](auto& json) { json["version"] = 2; })),
                HasSubstr("version 2, and this raylab reads version 1"));
    EXPECT_THAT(error_of("{\"score\": 100}"), HasSubstr("\"format\""));
    EXPECT_THAT(error_of("{"), HasSubstr("marks.json:1:"));
}

TEST(MarksJson, PointsThatNoVerdictGivesAreRefused) {
    EXPECT_THAT(error_of(changed([](auto& json) { json["tasks"][1]["score"] = 15; })),
                HasSubstr("/tasks/1/score: expected 0"));
    EXPECT_THAT(error_of(changed([](auto& json) { json["score"] = 45; })),
                HasSubstr("expected 30"));
    EXPECT_THAT(error_of(changed([](auto& json) { json["max_score"] = 30; })),
                HasSubstr("expected 45"));
    EXPECT_THAT(error_of(changed([](auto& json) { json["verdict"] = "PASS"; })),
                HasSubstr("WRONG_IMAGE"));
    EXPECT_THAT(error_of(changed([](auto& json) { json["tasks"][0]["max_score"] = -1; })),
                HasSubstr("from 0 to"));
}

TEST(MarksJson, AVerdictThatIsNoneIsRefused) {
    EXPECT_THAT(error_of(changed([](auto& json) { json["tasks"][0]["verdict"] = "PASSED"; })),
                HasSubstr("did you mean \"PASS\""));
    EXPECT_THAT(error_of(changed([](auto& json) { json["tasks"][0].erase("verdict"); })),
                HasSubstr("\"verdict\""));
    EXPECT_THAT(error_of(changed([](auto& json) { json["bonus"] = 5; })), HasSubstr("unknown key"));
}

TEST(MarksJson, StaysReadableWhateverASubmissionSays) {
    Marks marks;
    for (int i = 0; i < 64; ++i) {
        marks.tasks.push_back(mark_of("2.1", MarkVerdict::crash, 10));
        marks.tasks.back().reasons.assign(20, std::string(1 << 13, '\x01'));
    }
    marks.log = std::string(8 << 20, '\xFF');
    marks.compiler = std::string(8 << 20, '"');
    marks.ignored.assign(10000, std::string(400, '\\'));
    const std::string text = marks_json(marks);
    EXPECT_LE(text.size(), most_of_marks_json);
    EXPECT_EQ(read_marks_json(text, "marks.json").tasks.size(), 64u);
    EXPECT_THAT(error_of(std::string(most_of_marks_json + 1, ' ')), HasSubstr("at most"));
}

TEST(Overall, IsTheGravestOfATask) {
    Marks marks = example();
    EXPECT_EQ(overall(marks), MarkVerdict::wrong_image);
    marks.tasks.push_back(mark_of("2.3", MarkVerdict::not_implemented, 1));
    EXPECT_EQ(overall(marks), MarkVerdict::wrong_image);
    marks.tasks.push_back(mark_of("2.4", MarkVerdict::suspicious, 1));
    EXPECT_EQ(overall(marks), MarkVerdict::suspicious);
    marks.compiler = "path.h:1:1: error";
    EXPECT_EQ(overall(marks), MarkVerdict::compile_error);
    marks.trouble = "the disk is full";
    EXPECT_EQ(overall(marks), MarkVerdict::internal);
    for (const MarkVerdict verdict : all_verdicts()) { // none is forgotten
        Marks one;
        one.tasks = {mark_of("1.1", verdict, 1)};
        EXPECT_EQ(overall(one), verdict);
        EXPECT_EQ(verdict_named(name(verdict)), verdict);
    }
    EXPECT_EQ(verdict_named("pass"), std::nullopt);
}

TEST(Circumstances, AreSaidInEveryFormatThatHasAPlaceForThem) {
    Marks marks = example();
    EXPECT_EQ(circumstances(marks), "missing: path.h\nnot used: notes.txt, a \xF0\x9F\x8E\x89.png\n"
                                    "sandbox: tier 1: bubblewrap\n");
    for (const char* format : {"marks", "gradescope", "prairielearn", "summary"}) {
        EXPECT_THAT(write_marks(format, marks), HasSubstr("tier 1: bubblewrap")) << format;
        EXPECT_THAT(write_marks(format, marks), HasSubstr("notes.txt")) << format;
    }
    marks.ignored.assign(100, "x");
    EXPECT_THAT(circumstances(marks), HasSubstr("and 80 more"));
}

} // namespace
} // namespace raylab
