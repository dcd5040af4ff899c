// raylab bench-rays where it is not: it traces rays, which students of lab 01 write themselves.
#include "app/commands.h"

namespace raylab::app {

Run add_bench_rays(CLI::App& app) {
    app.description("Measure rays a second: not in the tree of lab 01.");
    app.allow_extras();
    return []() -> ExitCode {
        throw UsageError("bench-rays is not in the tree of lab 01: it knows how to trace rays");
    };
}

} // namespace raylab::app
