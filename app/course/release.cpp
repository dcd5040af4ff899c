// raylab release: the trees that students get, one a lab, each built, checked and run before it
// appears.
#include "grader/course/release.h"
#include "app/course/commands.h"
#include "common/cli/folder_lock.h"
#include "common/cli/process.h"
#include "common/cli/progress.h"
#include "grader/course/answers.h"
#include "grader/course/released_as.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

constexpr double step_limit_seconds = 3600; // a first build, on a slow machine

struct ReleaseOptions {
    std::string folder;
    std::vector<std::string> labs;
    bool no_build = false, give_away = false;
};

// Runs the tree's own ./raylab; no file of this build takes part. If ccache is there, it reuses
// what it compiled for another release in another folder.
ProcessResult run_in_tree(const fs::path& tree, const std::vector<std::string>& arguments) {
    std::vector<std::string> command = {
        "env",     "-u", "RAYLAB_PRESET", "CCACHE_NOHASHDIR=1", "CCACHE_BASEDIR=" + tree.string(),
        "./raylab"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run_process(command, {step_limit_seconds, tree});
}

// In the tree as students first meet it every task is NOT IMPLEMENTED, and `check` says in which
// file and line.
void expect_stubs(const LabSheet& sheet, const fs::path& tree) {
    const ProcessResult check = run_in_tree(tree, {"check", sheet.number, "--json"});
    const std::size_t at = check.output.find('{');
    const auto report = at == std::string::npos
                            ? nlohmann::json(nlohmann::json::value_t::discarded)
                            : nlohmann::json::parse(check.output.substr(at), nullptr, false);
    if (check.exit_code != 1 || report.is_discarded() || !report.at("compiles"))
        throw std::runtime_error(
            fmt::format("the tree of lab {} does not build, or its check ended with {} instead of "
                        "1:\n{}",
                        sheet.number, check.exit_code, check.output));
    for (const auto& task : report.at("tasks"))
        if (task.at("verdict") != name(TaskVerdict::not_implemented) ||
            task.at("not_implemented").at(0).at("task") != task.at("id"))
            throw std::runtime_error(fmt::format("in the tree of lab {}, task {} is {} and should "
                                                 "be NOT IMPLEMENTED:\n{}",
                                                 sheet.number, task.at("id").get<std::string>(),
                                                 task.at("verdict").get<std::string>(),
                                                 task.dump(2)));
}

void expect_render(const LabSheet& sheet, const fs::path& tree) {
    if (sheet.scenes.empty()) return;
    const std::string image = (tree / "build/first.exr").string();
    const ProcessResult render =
        run_in_tree(tree, {"render", sheet.number, sheet.scenes.front(), "--spp", "1", "--width",
                           "16", "--height", "16", "-q", "-o", image});
    if (!render.succeeded() || !fs::exists(image))
        throw std::runtime_error(fmt::format("in the tree of lab {}, `./raylab render` ended with "
                                             "{}:\n{}",
                                             sheet.number, render.exit_code, render.output));
}

// A tree that is written, in a folder of its own beside its place.
struct Part {
    LabSheet sheet;
    fs::path folder, target;
    ReleasedTree tree;
    std::vector<Answer> answers; // to tasks of earlier labs
};

Part write_part(const LabSheet& sheet, const ReleaseOptions& options) {
    const fs::path target = fs::path(options.folder) / sheet.folder;
    const fs::path part = fs::absolute(fs::path(options.folder) / ("." + sheet.folder + ".part"));
    if (fs::exists(target))
        throw CourseError(fmt::format("'{}' is there already: remove it, or name another folder "
                                      "with -o",
                                      target.string()));
    fs::remove_all(part); // left by a release that was interrupted
    fs::create_directories(part);
    const LabSources lab = read_lab_sources(sheet);
    const ReleasedTree tree = write_student_tree(lab, part);
    const std::vector<std::string> found = leaks(part, tree.solution_lines);
    if (!found.empty()) {
        std::string list;
        for (const std::string& leak : found) list += "\n  " + leak;
        fs::remove_all(part);
        throw std::runtime_error(fmt::format("lines of solutions that are not to be seen stand in "
                                             "what students of lab {} would get:{}",
                                             sheet.number, list));
    }
    Part written = {sheet, part, target, tree, earlier_answers(sheet, part)};
    pack_release(part);
    return written;
}

// Who gets two trees at once can read in one what he is to write in the other.
void expect_nothing_given_away(const std::vector<Part>& parts) {
    std::string told;
    for (const Part& part : parts)
        for (const Part& other : parts) {
            std::vector<Answer> answers;
            for (const Answer& answer : part.answers)
                if (other.sheet.find(answer.task)) answers.push_back(answer);
            if (!answers.empty())
                told += fmt::format("lab {}'s tree answers tasks of lab {}:\n{}", part.sheet.number,
                                    other.sheet.number, to_text(answers));
        }
    if (told.empty()) return;
    for (const Part& part : parts) fs::remove_all(part.folder);
    throw CourseError(fmt::format("{}Nothing was released. Release one lab when its predecessor is "
                                  "handed in (--labs {}), or all the same with --give-away",
                                  told, parts.front().sheet.number));
}

void build_and_name(const Part& part, const ReleaseOptions& options) {
    if (!options.no_build) {
        fmt::print(stderr, "{}: building and checking it as its students will, for minutes\n",
                   part.target.string());
        expect_stubs(part.sheet, part.folder);
        expect_render(part.sheet, part.folder);
        fs::remove_all(part.folder / "build"); // it contains the path of the temporary folder
    }
    fs::rename(part.folder, part.target);
    fmt::print("{}: {} files; none of {} lines of this lab's and later solutions; {}\n",
               part.target.string(), part.tree.files, part.tree.solution_lines.size(),
               options.no_build ? "not built"
                                : fmt::format("built: all {} tasks NOT IMPLEMENTED, renders",
                                              part.sheet.tasks.size()));
    if (!part.answers.empty())
        fmt::print("  it stands on earlier labs, and answers of their tasks:\n{}",
                   to_text(part.answers));
}

ExitCode run_release(const Tree& tree, const ReleaseOptions& options) {
    std::vector<std::string> labs = options.labs;
    if (labs.empty()) labs = lab_folders(tree.root);
    if (labs.empty())
        throw std::runtime_error(
            fmt::format("{} has no lab: nothing was released", tree.root.string()));
    std::vector<LabSheet> sheets; // all are read before the first is released
    for (const std::string& lab : labs) sheets.push_back(find_lab(tree.root, lab));
    // Each release begins by removing what an interrupted one left in the folder.
    const FolderLock lock(options.folder);
    if (!lock.held())
        throw CourseError(fmt::format("another release is writing to '{}': wait for its end, or "
                                      "name another folder with -o",
                                      options.folder));
    std::vector<Part> parts;
    for (const LabSheet& sheet : sheets) parts.push_back(write_part(sheet, options));
    if (!options.give_away) expect_nothing_given_away(parts);
    Progress progress("releasing", static_cast<int>(parts.size()), "labs", 1);
    int done = 0;
    for (const Part& part : parts) {
        build_and_name(part, options);
        progress.update(++done);
    }
    return ExitCode::success;
}

} // namespace

Run add_release(CLI::App& app, const Tree& tree) {
    auto options = std::make_shared<ReleaseOptions>();
    app.description("Write the trees that students get: stubs, handouts, public tests, scenes; no "
                    "solutions.");
    app.add_option("-o,--output", options->folder, "folder for one tree a lab")->required();
    app.add_option("--labs", options->labs, "labs, such as 01,02 (default: all)")->delimiter(',');
    app.add_flag("--no-build", options->no_build,
                 "do not build and check each tree before it appears");
    app.add_flag("--give-away", options->give_away,
                 "write trees of which one answers tasks of another");
    app.footer(
        "Examples:\n  raylab release -o out/students --labs 02\n"
        "  raylab release -o out/all --give-away\n"
        "A lab's tree stands on the labs before it and has answers to their tasks: a table "
        "says which.\nEach lab's tree is whole: ./raylab check, render and demo work in it.");
    return [options, tree] { return run_release(tree, *options); };
}

} // namespace raylab::app
