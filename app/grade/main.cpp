// raylab-grade: the program behind `raylab grade`, `raylab autograder` and `raylab doctor`.
#include "app/grade/commands.h"
#include "common/cli/files.h"
#include "common/cli/interrupt.h"
#include "common/cli/own_tree.h"
#include "common/load/scene_error.h"
#include "grader/course/course_error.h"
#include "grader/submissions/submission_error.h"

#include <fmt/format.h>

namespace {

int fail(const std::exception& error, raylab::ExitCode code) {
    fmt::print(stderr, "raylab: {}\n", error.what());
    return static_cast<int>(code);
}

} // namespace

int main(int argc, char** argv) {
    using namespace raylab;
    catch_signals();
    const app::GraderTree tree = {RAYLAB_ROOT, RAYLAB_BUILD, RAYLAB_DRAW_PROGRAM};
    CLI::App cli("raylab: grade submissions", "raylab");
    cli.require_subcommand(1);
    std::map<CLI::App*, app::Run> runs;
    const auto add = [&](const char* name, app::Run (*command)(CLI::App&, const app::GraderTree&)) {
        CLI::App* sub = cli.add_subcommand(name);
        runs[sub] = command(*sub, tree);
    };
    add("grade", app::add_grade);
    add("autograder", app::add_autograder);
    add("doctor", app::add_doctor);
    try {
        cli.parse(argc, argv);
        expect_own_tree(RAYLAB_PROGRAM_FILE, tree.root);
        return static_cast<int>(runs.at(cli.get_subcommands().front())());
    } catch (const CLI::ParseError& error) {
        const bool asked_for_help = error.get_exit_code() == 0;
        cli.exit(error);
        return static_cast<int>(asked_for_help ? ExitCode::success : ExitCode::bad_usage);
    } catch (const CourseError& error) {
        return fail(error, ExitCode::bad_usage);
    } catch (const SubmissionError& error) {
        return fail(error, ExitCode::bad_usage);
    } catch (const FileError& error) {
        return fail(error, error.code);
    } catch (const std::filesystem::filesystem_error& error) {
        const FileError translated = file_error(error);
        return fail(translated, translated.code);
    } catch (const std::exception& error) {
        return fail(error, ExitCode::tool_failed);
    }
}
