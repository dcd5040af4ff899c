#include "grader/course/mutant.h"

#include "common/cli/files.h"
#include "common/load/node.h"
#include "common/load/scene_error.h"
#include "grader/course/code_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace raylab {

namespace fs = std::filesystem;

namespace {

struct Equivalent {
    std::string file, was, is, why, place;
    bool used = false;
};

std::vector<Equivalent> read_equivalents(const LabSheet& sheet) {
    const fs::path path = sheet.path() / "equivalent.json";
    std::vector<Equivalent> all;
    if (!fs::exists(path)) return all;
    try {
        const JsonDocument document =
            parse_json(read_file(path.string()), path.lexically_relative(sheet.root).string());
        const Node top(document);
        top.expect_keys({"version", "mutants"}, "the list of equivalent mutants");
        if (top.at("version").integer() != 1) top.at("version").fail("expected version 1");
        for (const Node& entry : top.at("mutants").elements()) {
            entry.expect_keys({"file", "was", "is", "why"}, "an equivalent mutant");
            all.push_back({entry.at("file").string(), entry.at("was").string(),
                           entry.at("is").string(), entry.at("why").string(), entry.place()});
        }
    } catch (const SceneError& error) {
        throw CourseError(error.what());
    }
    return all;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

std::vector<std::string> lines_in(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

// Lines `first` to `end`, each run of white space one space.
std::string on_one_line(const std::vector<std::string>& lines, std::size_t first, std::size_t end) {
    std::string text;
    for (std::size_t i = first; i < end; ++i) {
        std::istringstream words(lines[i]);
        for (std::string word; words >> word;) text += (text.empty() ? "" : " ") + word;
    }
    return text;
}

// The mutant of a region by an edit of its text; what it has of the lab's is filled in already.
Mutant mutated(Mutant mutant, const MarkedRegion& region, const std::string& code,
               const CodeEdit& edit) {
    const std::vector<std::string>& before = region.solution;
    mutant.new_solution = lines_in(edit.apply(code));
    const auto count = [](const std::string& text) {
        return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    };
    const std::size_t first = count(code.substr(0, edit.at));
    const std::size_t end = first + count(code.substr(edit.at, edit.size)) + 1;
    mutant.line = region.line + 1 + static_cast<int>(first);
    mutant.kind = edit.kind;
    mutant.was = on_one_line(before, first, end);
    mutant.is =
        on_one_line(mutant.new_solution, first, mutant.new_solution.size() + end - before.size());
    return mutant;
}

} // namespace

std::vector<Mutant> mutants_of(const LabSources& lab) {
    std::vector<Equivalent> equivalents = read_equivalents(lab.sheet);
    std::vector<Mutant> all;
    const std::string folder = "labs/" + lab.sheet.folder + "/";
    for (std::size_t s = 0; s < lab.files.size(); ++s) {
        const std::vector<const MarkedRegion*> regions = lab.files[s].regions();
        const std::string file = lab.files[s].file.substr(folder.size());
        for (std::size_t r = 0; r < regions.size(); ++r) {
            const std::string code = joined(regions[r]->solution);
            for (const CodeEdit& edit : edits_of(code)) {
                const Mutant place{regions[r]->id, file, 0, "", "", "", {}, s, r, {}};
                all.push_back(mutated(place, *regions[r], code, edit));
            }
        }
    }
    for (Mutant& mutant : all)
        for (Equivalent& known : equivalents)
            if (known.file == mutant.file && known.was == mutant.was && known.is == mutant.is) {
                mutant.why_equivalent = known.why;
                known.used = true;
            }
    for (const Equivalent& known : equivalents)
        if (!known.used)
            throw CourseError(fmt::format("{}: the solution has no such mutant any more: bring the "
                                          "entry up to date",
                                          known.place));
    return all;
}

LabSources planted(const LabSources& lab, const Mutant& mutant) {
    LabSources with = lab;
    std::size_t r = 0;
    for (MarkedSource::Piece& piece : with.files[mutant.source].pieces)
        for (MarkedRegion& region : piece.region)
            if (r++ == mutant.region) region.solution = mutant.new_solution;
    return with;
}

} // namespace raylab
