// Stands in for prove.cpp and release.cpp in released trees, which have no solutions to work with.
#include "app/course/commands.h"

namespace raylab::app {

namespace {

Run not_here(CLI::App& app, const char* what) {
    app.description(std::string(what) + ": in the instructors' tree only.");
    app.allow_extras();
    return [&app]() -> ExitCode {
        throw CourseError(app.get_name() + " is in the instructors' tree only: it needs the "
                                           "solutions");
    };
}

} // namespace

Run add_prove(CLI::App& app, const Tree&) { return not_here(app, "Test the tasks' tests"); }
Run add_release(CLI::App& app, const Tree&) { return not_here(app, "Write trees for students"); }

} // namespace raylab::app
