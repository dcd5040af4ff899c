// raylab release: the trees that students get, one a lab, each built, checked and run before it
// appears.
#include "grader/course/release.h"
#include "app/course/commands.h"
#include "common/cli/process.h"
#include "common/cli/progress.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

constexpr double step_limit_seconds = 3600; // a first build, on a slow machine

struct ReleaseOptions {
    std::string folder;
    std::vector<std::string> labs;
    bool no_build = false;
};

// Only one release at a time may write to a folder, because each begins by removing what an
// interrupted one left there.
class FolderLock {
  public:
    explicit FolderLock(const std::string& folder) {
        fs::create_directories(folder);
        handle_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (handle_ >= 0 && flock(handle_, LOCK_EX | LOCK_NB) == 0) return;
        const int error = errno;
        if (handle_ >= 0) close(handle_);
        if (error != EWOULDBLOCK) throw std::system_error(error, std::generic_category(), folder);
        throw CourseError(fmt::format("another release is writing to '{}': wait for its end, or "
                                      "name another folder with -o",
                                      folder));
    }
    ~FolderLock() { close(handle_); }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int handle_;
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
        if (task.at("verdict") != name(Verdict::not_implemented) ||
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

void release_lab(const LabSheet& sheet, const ReleaseOptions& options) {
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
        throw std::runtime_error(fmt::format("lines of lab {}'s solution stand in what its "
                                             "students would get:{}",
                                             sheet.number, list));
    }
    if (!options.no_build) {
        fmt::print(stderr, "{}: building and checking it as its students will, for minutes\n",
                   target.string());
        expect_stubs(sheet, part);
        expect_render(sheet, part);
        fs::remove_all(part / "build"); // it contains the path of the temporary folder
    }
    fs::rename(part, target);
    fmt::print("{}: {} files; none of {} lines of the solution; {}\n", target.string(), tree.files,
               tree.solution_lines.size(),
               options.no_build ? "not built"
                                : fmt::format("built: all {} tasks NOT IMPLEMENTED, renders",
                                              sheet.tasks.size()));
}

ExitCode run_release(const Tree& tree, const ReleaseOptions& options) {
    std::vector<std::string> labs = options.labs;
    if (labs.empty()) labs = lab_folders(tree.root);
    if (labs.empty())
        throw std::runtime_error(
            fmt::format("{} has no lab: nothing was released", tree.root.string()));
    std::vector<LabSheet> sheets; // all are read before the first is released
    for (const std::string& lab : labs) sheets.push_back(find_lab(tree.root, lab));
    const FolderLock lock(options.folder);
    Progress progress("releasing", static_cast<int>(sheets.size()), "labs", 1);
    int done = 0;
    for (const LabSheet& sheet : sheets) {
        release_lab(sheet, options);
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
    app.footer("Examples:\n  raylab release -o out/students\n"
               "  raylab release -o out/students --labs 01\n"
               "Each lab's tree is whole: ./raylab check, render and demo work in it.");
    return [options, tree] { return run_release(tree, *options); };
}

} // namespace raylab::app
