// raylab-class: the program behind `raylab grade-class`.
#include "app/class/commands.h"
#include "app/program.h"
#include "common/cli/interrupt.h"
#include "common/cli/own_tree.h"
#include "grader/course/course_error.h"
#include "grader/submissions/submission_error.h"

int main(int argc, char** argv) {
    using namespace raylab;
    catch_signals();
    CLI::App cli("raylab: mark a class", "raylab");
    cli.require_subcommand(1);
    const app::Run run = app::add_grade_class(*cli.add_subcommand("grade-class"), RAYLAB_ROOT,
                                              RAYLAB_BUILD "/app/grade/raylab-grade");
    return app::run_program<CourseError, SubmissionError>(cli, argc, argv, [&] {
        expect_own_tree(RAYLAB_PROGRAM_FILE, RAYLAB_ROOT);
        return run();
    });
}
