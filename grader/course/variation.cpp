#include "grader/course/variation.h"

#include "common/cli/files.h"
#include "common/load/node.h"
#include "common/load/scene_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace raylab {

namespace fs = std::filesystem;

namespace {

std::string joined_lines(const Node& list) {
    std::string text;
    for (const Node& line : list.elements()) text += line.string() + "\n";
    return text;
}

// What variations and mistakes have in common.
Variation read_change(const LabSheet& sheet, const fs::path& path, const Node& top) {
    const Node file = top.at("file");
    if (!fs::is_regular_file(sheet.path() / file.string()))
        file.fail(fmt::format("lab {} has no file '{}'", sheet.number, file.string()));
    const std::string find = joined_lines(top.at("find"));
    if (find.empty()) top.at("find").fail("expected at least one line");
    return {path.stem().string(),
            top.at("find").place(),
            top.at("title").string(),
            file.string(),
            find,
            joined_lines(top.at("replace"))};
}

Variation read_variation(const LabSheet& sheet, const fs::path& path, const Node& top) {
    top.expect_keys({"title", "file", "find", "replace"}, "a variation");
    return read_change(sheet, path, top);
}

Mistake read_mistake(const LabSheet& sheet, const fs::path& path, const Node& top) {
    top.expect_keys({"title", "task", "cause", "file", "find", "replace"}, "a mistake");
    const std::string task = top.at("task").string();
    if (!sheet.find(task))
        top.at("task").fail(fmt::format("lab {} has no task '{}'", sheet.number, task));
    Mistake mistake{read_change(sheet, path, top), task, {}};
    for (const Node& cause : top.at("cause").elements()) mistake.causes.push_back(cause.string());
    return mistake;
}

// One of each file in a folder of the lab, in the order of their names; a lab may have none.
template <class Read> auto read_all(const LabSheet& sheet, const char* folder, Read read) {
    std::vector<fs::path> files;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(sheet.path() / folder, ignored))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<decltype(read(sheet, fs::path(), std::declval<Node>()))> all;
    try {
        for (const fs::path& file : files) {
            const JsonDocument document =
                parse_json(read_file(file.string()), file.lexically_relative(sheet.root).string());
            all.push_back(read(sheet, file, Node(document)));
        }
    } catch (const SceneError& error) {
        throw CourseError(error.what());
    }
    return all;
}

std::string in_lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

} // namespace

std::string Variation::apply(const std::string& text) const {
    // Whole lines: what is found begins where a line begins.
    const std::string lines = "\n" + text;
    const std::size_t at = lines.find("\n" + find);
    if (at == lines.npos)
        throw CourseError(fmt::format("{}: these lines are not in the solution of {} any more: "
                                      "bring the variation up to date",
                                      place, file));
    if (lines.find("\n" + find, at + 1) != lines.npos)
        throw CourseError(fmt::format("{}: these lines are in the solution of {} more than once: "
                                      "add a line that tells which are meant",
                                      place, file));
    return text.substr(0, at) + replace + text.substr(at + find.size());
}

bool Mistake::is_named_by(const std::string& fact) const {
    const std::string words = in_lower_case(fact);
    return std::any_of(causes.begin(), causes.end(), [&](const std::string& cause) {
        return words.find(in_lower_case(cause)) != std::string::npos;
    });
}

std::vector<Variation> read_variations(const LabSheet& sheet) {
    return read_all(sheet, "variations", read_variation);
}

std::vector<Mistake> read_mistakes(const LabSheet& sheet) {
    return read_all(sheet, "mistakes", read_mistake);
}

} // namespace raylab
