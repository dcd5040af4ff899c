// raylab-class: the program behind `raylab grade-class`.
#include "app/class/commands.h"
#include "common/cli/files.h"
#include "common/cli/interrupt.h"
#include "common/cli/own_tree.h"
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
    CLI::App cli("raylab: mark a class", "raylab");
    cli.require_subcommand(1);
    const app::Run run = app::add_grade_class(*cli.add_subcommand("grade-class"), RAYLAB_ROOT,
                                              RAYLAB_BUILD "/app/grade/raylab-grade");
    try {
        cli.parse(argc, argv);
        expect_own_tree(RAYLAB_PROGRAM_FILE, RAYLAB_ROOT);
        return static_cast<int>(run());
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
