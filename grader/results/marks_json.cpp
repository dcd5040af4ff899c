#include "grader/results/marks_json.h"

#include "common/load/node.h"
#include "common/load/scene_error.h"
#include "grader/results/text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace raylab {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr const char* format_name = "raylab marks";

// What a file may hold. JSON needs up to three bytes for one that is no text (U+FFFD), so the
// largest file stays below most_of_marks_json: 64 tasks of 8 reasons take 3 MiB at most.
constexpr std::size_t most_tasks = 64, most_reasons = 8, most_files = 200;
constexpr std::size_t reason_bytes = 2 << 10, name_bytes = 200, words_bytes = 64 << 10;

std::string text_of(const std::string& text, std::size_t most) {
    return shortened(clean_utf8(shortened(text, most)), most);
}

OrderedJson list_of(const std::vector<std::string>& texts, std::size_t most, std::size_t bytes) {
    OrderedJson list = OrderedJson::array();
    for (const std::string& text : texts) {
        if (list.size() == most) break;
        list.push_back(text_of(text, bytes));
    }
    return list;
}

OrderedJson task_json(const Mark& mark) {
    return {{"id", text_of(mark.id, name_bytes)},
            {"title", text_of(mark.title, name_bytes)},
            {"verdict", name(mark.verdict)},
            {"score", mark.points()},
            {"max_score", mark.of_points},
            {"reasons", list_of(mark.reasons, most_reasons, reason_bytes)},
            {"file", text_of(mark.file, name_bytes)},
            {"line", mark.line},
            {"read_on", text_of(mark.read_on, name_bytes)},
            {"seconds", mark.seconds}};
}

// Not negative, and small enough that no sum of them overflows.
int count(const Node& node) {
    const int value = node.integer();
    if (value < 0 || value > 1000000) node.fail_expected("a whole number from 0 to 1000000");
    return value;
}

std::vector<std::string> strings(const Node& node, std::size_t most) {
    std::vector<std::string> list;
    for (const Node& element : node.elements()) {
        if (list.size() == most) node.fail(fmt::format("more than {} elements", most));
        list.push_back(element.string());
    }
    return list;
}

MarkVerdict verdict_of(const Node& node) {
    std::vector<std::string> known;
    for (const MarkVerdict verdict : all_verdicts()) known.emplace_back(name(verdict));
    return verdict_named(node.word(known)).value();
}

void expect_points(const Node& node, int points) {
    if (count(node) != points)
        node.fail(fmt::format("expected {}, which follows from the verdicts; correct those, or "
                              "grade again",
                              points));
}

Mark read_task(const Node& node) {
    node.expect_keys({"id", "title", "verdict", "score", "max_score", "reasons", "file", "line",
                      "read_on", "seconds"},
                     "a task");
    Mark mark;
    mark.id = node.at("id").string();
    mark.title = node.at("title").string();
    mark.verdict = verdict_of(node.at("verdict"));
    mark.of_points = count(node.at("max_score"));
    mark.reasons = strings(node.at("reasons"), most_reasons);
    mark.file = node.at("file").string();
    mark.line = count(node.at("line"));
    mark.read_on = node.at("read_on").string();
    mark.seconds = node.at("seconds").not_negative();
    expect_points(node.at("score"), mark.points());
    return mark;
}

Marks read(const Node& node) {
    node.expect_object();
    if (node.at("format").string() != format_name)
        node.at("format").fail_expected(fmt::format("\"{}\"", format_name));
    if (const int version = node.at("version").integer(); version != marks_version)
        node.at("version").fail(fmt::format("this file has version {}, and this raylab reads "
                                            "version {}: grade the submission again",
                                            version, marks_version));
    node.expect_keys({"format", "version", "lab", "title", "grader", "sandbox", "seconds", "score",
                      "max_score", "verdict", "trouble", "compiler", "log", "missing", "ignored",
                      "tasks"},
                     "marks");
    Marks marks;
    marks.lab = node.at("lab").string();
    marks.title = node.at("title").string();
    marks.grader = node.at("grader").string();
    marks.sandbox = node.at("sandbox").string();
    marks.seconds = node.at("seconds").not_negative();
    marks.trouble = node.at("trouble").string();
    marks.compiler = node.at("compiler").string();
    marks.log = node.at("log").string();
    marks.missing = strings(node.at("missing"), most_files);
    marks.ignored = strings(node.at("ignored"), most_files);
    for (const Node& task : node.at("tasks").elements()) {
        if (marks.tasks.size() == most_tasks)
            task.fail(fmt::format("more than {} tasks", most_tasks));
        marks.tasks.push_back(read_task(task));
    }
    expect_points(node.at("score"), marks.points());
    expect_points(node.at("max_score"), marks.of_points());
    if (verdict_of(node.at("verdict")) != overall(marks))
        node.at("verdict").fail_expected(fmt::format("\"{}\"", name(overall(marks))));
    return marks;
}

} // namespace

std::string marks_json(const Marks& marks) {
    OrderedJson tasks = OrderedJson::array();
    for (const Mark& mark : marks.tasks) tasks.push_back(task_json(mark));
    const OrderedJson json = {{"format", format_name},
                              {"version", marks_version},
                              {"lab", text_of(marks.lab, name_bytes)},
                              {"title", text_of(marks.title, name_bytes)},
                              {"grader", text_of(marks.grader, name_bytes)},
                              {"sandbox", text_of(marks.sandbox, reason_bytes)},
                              {"seconds", marks.seconds},
                              {"score", marks.points()},
                              {"max_score", marks.of_points()},
                              {"verdict", name(overall(marks))},
                              {"trouble", text_of(marks.trouble, words_bytes)},
                              {"compiler", text_of(marks.compiler, words_bytes)},
                              {"log", text_of(marks.log, words_bytes)},
                              {"missing", list_of(marks.missing, most_files, name_bytes)},
                              {"ignored", list_of(marks.ignored, most_files, name_bytes)},
                              {"tasks", tasks}};
    return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

Marks read_marks_json(std::string_view text, const std::string& file) {
    if (text.size() > most_of_marks_json)
        throw MarksError(
            fmt::format("{}: a file of marks has at most {} bytes, and this one has {}", file,
                        most_of_marks_json, text.size()));
    try {
        const JsonDocument document = parse_json(text, file);
        return read(Node(document));
    } catch (const SceneError& error) {
        throw MarksError(error.what());
    }
}

} // namespace raylab
