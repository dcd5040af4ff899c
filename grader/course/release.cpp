#include "grader/course/release.h"

#include "common/cli/files.h"
#include "common/load/suggest.h"
#include "grader/course/answers.h"
#include "grader/course/contains.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

namespace raylab {

namespace fs = std::filesystem;

namespace {

// What every released tree has, besides its lab. Of docs the guides for students, and the pages
// that these and what is given refer to; the instructor's guide and its answers stay behind.
const std::vector<std::string> given = {".clang-format",   ".clangd",
                                        ".devcontainer",   ".editorconfig",
                                        ".gitignore",      ".vscode",
                                        "CMakeLists.txt",  "CMakePresets.json",
                                        "LICENSE",         "packages.txt",
                                        "raylab",          "app",
                                        "cmake",           "common",
                                        "grader",          "scenes",
                                        "docs/guide",      "docs/formats.md",
                                        "docs/machine.md", "docs/programs.md",
                                        "docs/vendor.md",  "docs/images/environment_map.png"};

// Of these folders: what works with solutions, by the names of the files without ending. A tree
// without solutions does not compile it.
const std::map<fs::path, std::vector<std::string>> for_solutions = {
    {"app/course",
     {"in_a_cell", "proof_build", "prove", "prove_mistakes", "prove_mutants", "release"}},
    {"app/grade", {"doctor", "grade", "grade_report", "main"}},
    {"grader/course",
     {"answers", "code_edits", "code_text", "markers", "mutant", "release", "stub_tree",
      "variation"}}};

// What only instructors need.
const std::vector<fs::path> for_instructors = {"app/class",      "app/grade/autograder",
                                               "grader/class",   "grader/grading",
                                               "grader/sandbox", "grader/submissions"};

// The project's own tests contain answers, and generated files are not sources.
bool is_given(const fs::path& file) {
    for (const fs::path& part : file)
        if (part == "tests" || part == "fuzz" || part == "__pycache__") return false;
    if (contains(for_instructors, file.parent_path())) return false;
    const auto folder = for_solutions.find(file.parent_path());
    return folder == for_solutions.end() || !contains(folder->second, file.stem().string());
}

std::vector<fs::path> given_files(const fs::path& root) {
    std::vector<fs::path> files;
    for (const std::string& name : given) {
        if (fs::is_regular_file(root / name)) files.emplace_back(name);
        if (!fs::is_directory(root / name)) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / name)) {
            const fs::path file = entry.path().lexically_relative(root);
            if (entry.is_regular_file() && is_given(file)) files.push_back(file);
        }
    }
    return files;
}

// In students' builds warnings do not stop the compiler, and tests that are not released are left
// out.
std::string student_presets(const std::string& text) {
    nlohmann::ordered_json presets = nlohmann::ordered_json::parse(text);
    for (auto& preset : presets.at("configurePresets"))
        if (preset.at("name") == "base")
            preset["cacheVariables"] = {{"RAYLAB_STRICT", "OFF"}, {"RAYLAB_TESTS", "OFF"}};
    return presets.dump(4) + "\n";
}

// The editor offers the tree's own lab alone, and no task for the tests that are not released.
std::string student_editor(const std::string& text, const LabSheet& sheet) {
    using json = nlohmann::ordered_json;
    json settings = json::parse(text);
    for (json& input : settings.at("inputs"))
        if (input.at("id") == "lab") {
            input["options"] = json::array({sheet.number});
            input["default"] = sheet.number;
        }
    if (settings.contains("tasks")) {
        json tasks = json::array();
        for (const json& task : settings.at("tasks"))
            if (task.at("label") != "test") tasks.push_back(task);
        settings["tasks"] = tasks;
    }
    return settings.dump(4) + "\n";
}

std::string student_readme(const LabSheet& sheet) {
    const auto line = [](const std::string& command, const std::string& what) {
        return fmt::format("    {:40}# {}\n", "./raylab " + command, what);
    };
    std::string commands =
        line("check " + sheet.number, "every task: NOT IMPLEMENTED, WAITS, WRONG or PASS") +
        line(fmt::format("check {} {} --watch", sheet.number, sheet.tasks.front().id),
             "one task, again at every save");
    if (!sheet.scenes.empty())
        commands += line(fmt::format("render {} {} -o image.png", sheet.number, sheet.scenes[0]),
                         "scenes: " + listed(sheet.scenes));
    commands += line("demo", "everything rendered and judged") +
                line("--help", "every command; each has examples");
    return fmt::format("# raylab, lab {}: {}\n\n"
                       "The handout is [labs/{}/README.md](labs/{}/README.md). Fill in the tasks'\n"
                       "functions in that folder; each says where it is missing:\n\n{}\n"
                       "[docs/guide](docs/guide/README.md) helps with setup, mistakes and the "
                       "write-up.\n\n"
                       "The script installs what is missing (it asks once), configures and builds: "
                       "the first\ncheck takes minutes, every later one seconds.\n",
                       sheet.number, sheet.title, sheet.folder, sheet.folder, commands);
}

// A file of common as students of the lab get it; `stays`: it is not handed out.
struct Given {
    std::string text;
    bool stays = false;
};

// This lab and all later ones: what they withhold, and the lines of their solutions.
struct NotToSee {
    std::vector<std::string> files, numbers; // the labs' numbers
    std::set<std::string> lines;             // squeezed
};

NotToSee not_to_see(const LabSheet& sheet) {
    NotToSee hidden;
    for (const std::string& folder : lab_folders(sheet.root)) {
        const LabSheet lab = read_lab_sheet(sheet.root, folder);
        if (lab.number < sheet.number) continue;
        hidden.numbers.push_back(lab.number);
        for (const auto& [line, tasks] : solution_lines(read_lab_sources(lab)))
            hidden.lines.insert(line);
        for (const auto& [file, answers] : lab.withhold) {
            if (!fs::is_regular_file(sheet.root / file))
                throw CourseError(
                    fmt::format("labs/{}/lab.json: \"withhold\" names {}, which is not "
                                "there: correct the name",
                                folder, file));
            hidden.files.push_back(file);
        }
    }
    return hidden;
}

Given without_answers(const LabSheet& sheet, const NotToSee& hidden, const std::string& file,
                      std::set<std::string>& lines) {
    const MarkedSource source = parse_markers(read_file((sheet.root / file).string()), file);
    const bool listed = contains(hidden.files, file);
    bool has_region = false;
    for (const MarkedRegion* region : source.regions()) {
        if (region->kind != MarkedRegion::Kind::withhold)
            throw CourseError(fmt::format("{}:{}: only a lab has tasks", file, region->line));
        if (!contains(hidden.numbers, region->id)) continue;
        has_region = true;
        for (const std::string& line : telling_lines(*region)) lines.insert(line);
        if (!listed)
            throw CourseError(fmt::format("{}:{}: lab.json of {} does not list this file under "
                                          "\"withhold\": add it there",
                                          file, region->line, sheet.folder));
    }
    if (listed && !has_region) return {"", true};
    return {student_source(source,
                           [&](const MarkedRegion& r) { return contains(hidden.numbers, r.id); })};
}

} // namespace

std::string squeezed(const std::string& line) {
    // Lines that anybody would write: a name for a field, for an element, or for the result of one
    // call; the head of a loop that counts or goes through all elements.
    static const std::regex plain(
        R"(const[\w:<>&]+=[\w.:<>]+(\[[\w.]+\])?(\(([\w,.]|\(\))*\))?;)"
        R"(|for\(int\w+=0;\w+<[\w.]+;\+\+\w+\)\{?|for\(const\w+&\w+:[\w.]+\)\{?)");
    constexpr std::size_t shortest = 28;
    std::string code = line.substr(0, line.find("//"));
    std::erase_if(code, [](unsigned char c) { return std::isspace(c); });
    if (code.size() < shortest) return "";
    const bool may_be_plain = code.starts_with("const") || code.starts_with("for(");
    return may_be_plain && std::regex_match(code, plain) ? "" : code;
}

ReleasedTree write_student_tree(const LabSources& lab, const fs::path& target) {
    const LabSheet& sheet = lab.sheet;
    ReleasedTree tree;
    const NotToSee hidden = not_to_see(sheet);
    tree.solution_lines = hidden.lines;
    for (const fs::path& file : given_files(sheet.root)) {
        const std::string ending = file.extension().string();
        Given out;
        if (ending == ".h" || ending == ".cpp" || ending == ".cu")
            out = without_answers(sheet, hidden, file.string(), tree.solution_lines);
        else
            out.text = read_file((sheet.root / file).string());
        if (out.stays) continue;
        if (file == "CMakePresets.json") out.text = student_presets(out.text);
        if (file == ".vscode/tasks.json" || file == ".vscode/launch.json")
            out.text = student_editor(out.text, sheet);
        write_if_changed(target / file, out.text);
        fs::permissions(target / file, fs::status(sheet.root / file).permissions());
        ++tree.files;
    }
    const std::vector<std::string> ids = sheet.task_ids();
    write_lab(lab, {ids.begin(), ids.end()}, target);
    write_file((target / "README.md").string(), student_readme(sheet));
    return tree;
}

std::vector<std::string> telling_lines(const MarkedRegion& region) {
    std::set<std::string> said;
    for (const std::string& line : region.stub) said.insert(squeezed(line));
    std::vector<std::string> lines;
    for (const std::string& line : region.solution)
        if (const std::string code = squeezed(line); !code.empty() && !said.contains(code))
            lines.push_back(code);
    return lines;
}

void for_each_line(
    const fs::path& folder,
    const std::function<void(const std::string&, int, const std::string&)>& with_line) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const std::string ending = entry.path().extension().string();
        const bool text = ending == ".h" || ending == ".cpp" || ending == ".cu" ||
                          ending == ".md" || ending == ".json" || ending == ".in";
        if (!entry.is_regular_file() || !text) continue;
        const std::string file = entry.path().lexically_relative(folder).string();
        std::istringstream stream(read_file(entry.path().string()));
        int number = 0;
        for (std::string line; std::getline(stream, line);) with_line(file, ++number, line);
    }
}

std::vector<std::string> leaks(const fs::path& tree, const std::set<std::string>& solution_lines) {
    std::vector<std::string> found;
    for_each_line(tree, [&](const std::string& file, int number, const std::string& line) {
        const std::string code = squeezed(line);
        if (!code.empty() && solution_lines.contains(code))
            found.push_back(
                fmt::format("{}:{}: {}", file, number, line.substr(line.find_first_not_of(' '))));
    });
    return found;
}

} // namespace raylab
