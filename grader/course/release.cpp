#include "grader/course/release.h"

#include "common/cli/files.h"
#include "common/load/suggest.h"
#include "grader/course/contains.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>
#include <sstream>

namespace raylab {

namespace fs = std::filesystem;

namespace {

// What every released tree has, besides its lab.
const std::vector<std::string> given = {
    ".clang-format", ".clangd",      ".devcontainer",  ".editorconfig",
    ".gitignore",    ".vscode",      "CMakeLists.txt", "CMakePresets.json",
    "LICENSE",       "packages.txt", "raylab",         "app",
    "cmake",         "common",       "grader",         "scenes"};

// The project's own tests contain answers, and generated files are not sources.
bool is_given(const fs::path& file) {
    for (const fs::path& part : file)
        if (part == "tests" || part == "fuzz" || part == "__pycache__") return false;
    return true;
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
                       "The script installs what is missing (it asks once), configures and builds: "
                       "the first\ncheck takes minutes, every later one seconds.\n",
                       sheet.number, sheet.title, sheet.folder, sheet.folder, commands);
}

// The lines of the solution that are not in the stub beside it.
void collect(std::set<std::string>& lines, const Region& region) {
    std::set<std::string> said;
    for (const std::string& line : region.stub) said.insert(squeezed(line));
    for (const std::string& line : region.solution)
        if (const std::string code = squeezed(line); !code.empty() && !said.contains(code))
            lines.insert(code);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

// A file of common as students of the lab get it; `stays`: it is not handed out.
struct Given {
    std::string text;
    bool stays = false;
};

// What this lab and all later labs withhold.
struct Withheld {
    std::vector<std::string> files, numbers; // the labs' numbers
};

Withheld withheld_from(const LabSheet& sheet) {
    Withheld withheld;
    for (const std::string& folder : lab_folders(sheet.root)) {
        const LabSheet lab = read_lab_sheet(sheet.root, folder);
        if (lab.number < sheet.number) continue;
        withheld.numbers.push_back(lab.number);
        for (const std::string& file : lab.withhold) {
            if (!fs::is_regular_file(sheet.root / file))
                throw CourseError(
                    fmt::format("labs/{}/lab.json: \"withhold\" names {}, which is not "
                                "there: correct the name",
                                folder, file));
            withheld.files.push_back(file);
        }
    }
    return withheld;
}

Given without_answers(const LabSheet& sheet, const Withheld& withheld, const std::string& file,
                      std::set<std::string>& lines) {
    const MarkedSource source = parse_markers(read_file((sheet.root / file).string()), file);
    const bool listed = contains(withheld.files, file);
    bool has_region = false;
    for (const Region* region : source.regions()) {
        if (region->kind != Region::Kind::withhold)
            throw CourseError(fmt::format("{}:{}: only a lab has tasks", file, region->line));
        if (!contains(withheld.numbers, region->id)) continue;
        has_region = true;
        collect(lines, *region);
        if (!listed)
            throw CourseError(fmt::format("{}:{}: lab.json of {} does not list this file under "
                                          "\"withhold\": add it there",
                                          file, region->line, sheet.folder));
    }
    if (listed && !has_region) return {"", true};
    return {
        student_source(source, [&](const Region& r) { return contains(withheld.numbers, r.id); })};
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
    return code.size() < shortest || std::regex_match(code, plain) ? "" : code;
}

ReleasedTree write_student_tree(const LabSources& lab, const fs::path& target) {
    const LabSheet& sheet = lab.sheet;
    ReleasedTree tree;
    const Withheld withheld = withheld_from(sheet);
    for (const fs::path& file : given_files(sheet.root)) {
        const std::string ending = file.extension().string();
        Given out;
        if (ending == ".h" || ending == ".cpp" || ending == ".cu")
            out = without_answers(sheet, withheld, file.string(), tree.solution_lines);
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
    for (const MarkedSource& source : lab.files)
        for (const Region* region : source.regions()) collect(tree.solution_lines, *region);
    const std::vector<std::string> ids = sheet.task_ids();
    write_lab(lab, {ids.begin(), ids.end()}, target);
    write_file((target / "README.md").string(), student_readme(sheet));
    return tree;
}

std::vector<std::string> leaks(const fs::path& tree, const std::set<std::string>& solution_lines) {
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(tree)) {
        const std::string ending = entry.path().extension().string();
        const bool text = ending == ".h" || ending == ".cpp" || ending == ".cu" ||
                          ending == ".md" || ending == ".json" || ending == ".in";
        if (!entry.is_regular_file() || !text) continue;
        int number = 0;
        for (const std::string& line : lines_of(read_file(entry.path().string()))) {
            ++number;
            const std::string code = squeezed(line);
            if (!code.empty() && solution_lines.contains(code))
                found.push_back(fmt::format("{}:{}: {}",
                                            entry.path().lexically_relative(tree).string(), number,
                                            line.substr(line.find_first_not_of(' '))));
        }
    }
    return found;
}

} // namespace raylab
