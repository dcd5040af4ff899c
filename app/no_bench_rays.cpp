// Stands in for bench_rays.cpp in the tree of lab 01: bench-rays traces rays, and its students
// write that code themselves.
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
