// raylab-grade: the program behind `raylab grade`, `raylab autograder` and `raylab doctor`.
#include "app/grade/commands.h"
#include "app/program.h"
#include "common/cli/interrupt.h"
#include "common/cli/own_tree.h"
#include "grader/course/course_error.h"
#include "grader/submissions/submission_error.h"

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
    return app::run_program<CourseError, SubmissionError>(cli, argc, argv, [&] {
        expect_own_tree(RAYLAB_PROGRAM_FILE, tree.root);
        return runs.at(cli.get_subcommands().front())();
    });
}
