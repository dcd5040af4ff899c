#include "grader/course/variation.h"

#include "common/cli/files.h"
#include "common/load/node.h"
#include "common/load/scene_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace fs = std::filesystem;

namespace {

std::string joined_lines(const Node& list) {
    std::string text;
    for (const Node& line : list.elements()) text += line.string() + "\n";
    return text;
}

Variation read_variation(const LabSheet& sheet, const fs::path& path) {
    const JsonDocument document =
        parse_json(read_file(path.string()), path.lexically_relative(sheet.root).string());
    const Node top(document);
    top.expect_keys({"title", "file", "find", "replace"}, "a variation");
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

std::vector<Variation> read_variations(const LabSheet& sheet) {
    std::vector<Variation> variations;
    std::error_code ignored; // a lab may have none
    try {
        for (const fs::directory_entry& entry :
             fs::directory_iterator(sheet.path() / "variations", ignored))
            variations.push_back(read_variation(sheet, entry.path()));
    } catch (const SceneError& error) {
        throw CourseError(error.what());
    }
    std::sort(variations.begin(), variations.end(),
              [](const Variation& a, const Variation& b) { return a.name < b.name; });
    return variations;
}

} // namespace raylab
