// The formats that are JSON. Read from the platforms' documents, autumn 2026.
#include "grader/results/formats.h"
#include "grader/results/text.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <ctime>

namespace raylab {

using OrderedJson = nlohmann::ordered_json;

namespace {

constexpr std::size_t most_of_a_task = 16 << 10; // bytes of explanation that anybody reads

std::string dumped(const OrderedJson& json) {
    return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

std::string headline(const Marks& marks) {
    if (!marks.trouble.empty())
        return "INTERNAL: the grader has trouble of its own, and no mark changes";
    if (!marks.compiler.empty()) return "COMPILE_ERROR: the submission does not compile";
    return fmt::format("{} of {} points", marks.points(), marks.of_points());
}

// The compiler's words, or what the grader's own trouble is.
std::string details(const Marks& marks) {
    return clean_utf8(
        shortened(marks.trouble.empty() ? marks.compiler : marks.trouble, most_of_a_task));
}

std::string said_of(const Marks& marks) {
    const std::string text = clean_utf8(circumstances(marks));
    return text.empty() ? "" : "\n" + text;
}

std::string task_text(const Mark& mark) {
    return clean_utf8(
        shortened(std::string(name(mark.verdict)) + "\n" + explanation(mark), most_of_a_task));
}

std::string full_title(const Mark& mark) { return mark.id + " " + mark.title; }

} // namespace

std::string gradescope(const Marks& marks) {
    OrderedJson tests = OrderedJson::array();
    for (const Mark& mark : marks.tasks)
        tests.push_back({{"number", mark.id},
                         {"name", full_title(mark)},
                         {"score", mark.points()},
                         {"max_score", mark.of_points},
                         {"status", mark.verdict == MarkVerdict::pass ? "passed" : "failed"},
                         {"output", task_text(mark)},
                         {"output_format", "text"},
                         {"visibility", "visible"}});
    OrderedJson json = {
        {"score", marks.points()},
        {"execution_time", static_cast<int>(marks.seconds)},
        {"output", headline(marks) + "\n" + details(marks) + said_of(marks)},
        {"output_format", "text"},
        {"visibility", "visible"},
        {"stdout_visibility", "hidden"},
        {"extra_data",
         {{"lab", marks.lab}, {"grader", marks.grader}, {"sandbox", clean_utf8(marks.sandbox)}}},
        {"tests", tests}};
    return dumped(json);
}

std::string prairielearn(const Marks& marks) {
    const bool gradable = marks.trouble.empty() && marks.compiler.empty();
    // The whole file may have a megabyte; JSON may need six bytes for one.
    const std::size_t most =
        std::min(most_of_a_task, 150000 / std::max<std::size_t>(1, marks.tasks.size()));
    OrderedJson tests = OrderedJson::array();
    for (const Mark& mark : marks.tasks)
        tests.push_back({{"name", full_title(mark)},
                         {"points", mark.points()},
                         {"max_points", mark.of_points},
                         {"message", name(mark.verdict)},
                         {"output", clean_utf8(shortened(explanation(mark), most))}});
    OrderedJson json = {{"gradable", gradable},
                        {"score", marks.of_points() == 0
                                      ? 0.0
                                      : static_cast<double>(marks.points()) / marks.of_points()},
                        {"message", headline(marks)},
                        {"output", "graded by " + marks.grader + "\n" + said_of(marks)},
                        {"tests", tests}};
    if (!gradable) json["format_errors"] = OrderedJson::array({headline(marks), details(marks)});
    return dumped(json);
}

Classroom50 Classroom50::from_environment() {
    const auto of = [](const char* variable) {
        const char* text = std::getenv(variable);
        return std::string(text ? text : "");
    };
    return {of("CLASSROOM"),
            of("ASSIGNMENT"),
            of("SUBMISSION_TAG"),
            of("COMMIT_URL"),
            of("RELEASE_URL"),
            of("REVIEW_URL"),
            fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))};
}

std::string classroom50(const Marks& marks, const Classroom50& about) {
    OrderedJson tests = OrderedJson::array();
    for (const Mark& mark : marks.tasks)
        tests.push_back({{"test-name", full_title(mark)},
                         {"passed", mark.verdict == MarkVerdict::pass},
                         {"score", mark.points()},
                         {"max-score", mark.of_points}});
    return dumped({{"schema", "classroom50/result/v1"},
                   {"classroom", about.classroom},
                   {"assignment", about.assignment},
                   {"submission", about.submission},
                   {"commit", about.commit},
                   {"release", about.release},
                   {"review", about.review},
                   {"datetime", about.datetime},
                   {"score", marks.points()},
                   {"max-score", marks.of_points()},
                   {"tests", tests}});
}

} // namespace raylab
