// lab.json, strictly: the scene loader's reader finds the place of every mistake.
#include "grader/course/lab_sheet.h"

#include "common/cli/files.h"
#include "common/load/node.h"
#include "common/load/scene_error.h"
#include "common/load/suggest.h"
#include "grader/course/contains.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace fs = std::filesystem;

namespace {

std::string filled(const Node& node) {
    std::string text = node.string();
    if (text.empty()) node.fail("expected some text, found \"\"");
    return text;
}

int positive_integer(const Node& node) {
    const int value = node.integer();
    if (value < 1) node.fail_expected("an integer of at least 1");
    return value;
}

// Names of regular files below `folder`.
std::vector<std::string> read_files(const Node& list, const fs::path& folder) {
    std::vector<std::string> names;
    for (const Node& element : list.elements()) {
        const std::string name = filled(element);
        const fs::path normal = fs::path(name).lexically_normal();
        if (normal.is_absolute() || *normal.begin() == "..")
            element.fail(fmt::format("'{}' leads out of '{}'", name, folder.filename().string()));
        if (!fs::is_regular_file(folder / normal))
            element.fail(fmt::format("there is no file {}; create it, or correct the name",
                                     (folder / normal).string()));
        if (contains(names, normal.string())) element.fail("this file is listed twice");
        names.push_back(normal.string());
    }
    return names;
}

std::vector<std::string> read_words(const Node& list) {
    std::vector<std::string> words;
    for (const Node& element : list.elements()) words.push_back(filled(element));
    return words;
}

Task read_task(const Node& node, const LabSheet& sheet) {
    node.expect_keys(
        {"id", "title", "points", "minutes", "files", "tests", "needs", "hints", "picture"},
        "a task");
    Task task;
    task.id = filled(node.at("id"));
    const std::string expected =
        fmt::format("{}.{}", std::stoi(sheet.number), sheet.tasks.size() + 1);
    if (task.id != expected)
        node.at("id").fail(fmt::format("expected \"{}\", found \"{}\": tasks are numbered in the "
                                       "order of the list",
                                       expected, task.id));
    task.title = filled(node.at("title"));
    task.points = positive_integer(node.at("points"));
    task.minutes = positive_integer(node.at("minutes"));
    task.files = read_files(node.at("files"), sheet.path());
    if (task.files.empty())
        node.at("files").fail(
            fmt::format("task {} has no file: name where its markers are", task.id));
    task.tests = read_words(node.at("tests"));
    if (task.tests.empty())
        node.at("tests").fail(fmt::format("task {} has no tests: name at least one GoogleTest "
                                          "filter, such as \"Task2_1.*\"",
                                          task.id));
    if (const auto needs = node.find("needs")) task.needs = read_words(*needs);
    task.hints = filled(node.at("hints"));
    task.picture = filled(node.at("picture"));
    return task;
}

void check_needs(const Node& tasks, const LabSheet& sheet) {
    const std::vector<Node> nodes = tasks.elements();
    for (std::size_t i = 0; i < sheet.tasks.size(); ++i)
        for (const std::string& id : sheet.tasks[i].needs)
            if (!sheet.find(id) || id == sheet.tasks[i].id)
                nodes[i].at("needs").fail(fmt::format("there is no other task {}{}", id,
                                                      did_you_mean(id, sheet.task_ids())));
}

// A released tree does not have the files that the release withheld, so they are not looked for.
std::vector<Withheld> read_withheld(const Node& files, const LabSheet& sheet) {
    std::vector<Withheld> withheld;
    for (const auto& [file, answers] : files.members()) {
        withheld.push_back({file, {}});
        for (const Node& id : answers.elements()) {
            if (!sheet.find(id.string()))
                id.fail(fmt::format("lab {} has no task '{}'{}", sheet.number, id.string(),
                                    did_you_mean(id.string(), sheet.task_ids())));
            withheld.back().answers.insert(id.string());
        }
        if (withheld.back().answers.empty())
            answers.fail("name at least one task that this file answers");
    }
    return withheld;
}

std::vector<std::string> read_tasks(const Node& node, const LabSheet& sheet) {
    for (const Node& id : node.elements())
        if (!sheet.find(id.string()))
            id.fail(fmt::format("lab {} has no task '{}'{}", sheet.number, id.string(),
                                did_you_mean(id.string(), sheet.task_ids())));
    return read_words(node);
}

GradedPicture read_picture(const Node& node, const LabSheet& sheet) {
    node.expect_keys({"scene", "roulette", "options", "tasks", "counts"}, "a graded picture");
    GradedPicture picture;
    picture.scene = filled(node.at("scene"));
    if (const auto roulette = node.find("roulette")) picture.roulette = roulette->boolean();
    if (const auto options = node.find("options")) picture.options = read_words(*options);
    picture.tasks = read_tasks(node.at("tasks"), sheet);
    if (const auto counts = node.find("counts")) picture.counts = read_tasks(*counts, sheet);
    return picture;
}

LabSheet read_document(const JsonDocument& document, const fs::path& root,
                       const std::string& folder) {
    const Node top(document);
    top.expect_keys({"version", "number", "folder", "title", "tests", "test_files", "scenes",
                     "withhold", "tasks", "graded_pictures"},
                    "a lab");
    if (top.at("version").integer() != 1) top.at("version").fail_expected("1");
    LabSheet sheet;
    sheet.root = root;
    sheet.number = filled(top.at("number"));
    sheet.folder = filled(top.at("folder"));
    if (sheet.folder != folder)
        top.at("folder").fail(
            fmt::format("expected \"{}\", the folder that this file is in", folder));
    const bool digits =
        sheet.number.size() == 2 && std::isdigit(sheet.number[0]) && std::isdigit(sheet.number[1]);
    if (!digits || !folder.starts_with(sheet.number + "_"))
        top.at("number").fail(
            fmt::format("expected the two digits that \"{}\" begins with", folder));
    sheet.title = filled(top.at("title"));
    sheet.test_target = filled(top.at("tests"));
    sheet.test_files = read_files(top.at("test_files"), sheet.path());
    if (const auto scenes = top.find("scenes")) sheet.scenes = read_words(*scenes);
    for (const Node& node : top.at("tasks").elements())
        sheet.tasks.push_back(read_task(node, sheet));
    if (sheet.tasks.empty()) top.at("tasks").fail("a lab has at least one task");
    check_needs(top.at("tasks"), sheet);
    if (const auto pictures = top.find("graded_pictures"))
        for (const Node& node : pictures->elements())
            sheet.pictures.push_back(read_picture(node, sheet));
    if (const auto withhold = top.find("withhold"))
        sheet.withhold = read_withheld(*withhold, sheet);
    return sheet;
}

} // namespace

const Task* LabSheet::find(const std::string& id) const {
    const auto found =
        std::find_if(tasks.begin(), tasks.end(), [&](const Task& task) { return task.id == id; });
    return found == tasks.end() ? nullptr : &*found;
}

std::vector<std::string> LabSheet::task_ids() const {
    std::vector<std::string> ids;
    for (const Task& task : tasks) ids.push_back(task.id);
    return ids;
}

std::vector<std::string> LabSheet::files() const {
    std::vector<std::string> names;
    for (const Task& task : tasks)
        for (const std::string& file : task.files)
            if (!contains(names, file)) names.push_back(file);
    return names;
}

LabSheet read_lab_sheet(const fs::path& root, const std::string& folder) {
    const std::string name = "labs/" + folder + "/lab.json";
    try {
        const JsonDocument document = parse_json(read_file((root / name).string()), name);
        return read_document(document, root, folder);
    } catch (const SceneError& error) {
        throw CourseError(error.what());
    } catch (const FileError& error) {
        throw CourseError(error.what());
    }
}

std::vector<std::string> lab_folders(const fs::path& root) {
    std::vector<std::string> folders;
    std::error_code ignored; // a tree without labs has none
    for (const fs::directory_entry& entry : fs::directory_iterator(root / "labs", ignored))
        if (fs::exists(entry.path() / "lab.json"))
            folders.push_back(entry.path().filename().string());
    std::sort(folders.begin(), folders.end());
    return folders;
}

LabSheet find_lab(const fs::path& root, const std::string& name) {
    const std::vector<std::string> folders = lab_folders(root);
    for (const std::string& folder : folders) {
        const std::string number = folder.substr(0, folder.find('_'));
        if (name == number || "0" + name == number || name == folder)
            return read_lab_sheet(root, folder);
    }
    throw CourseError(fmt::format("there is no lab '{}'; the labs are {}", name, listed(folders)));
}

} // namespace raylab
