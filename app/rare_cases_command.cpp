// raylab rare-cases: where a wavefront gains nothing, measured.
#include "app/commands.h"
#include "app/rare_cases.h"

#include <fmt/format.h>

namespace raylab::app {

namespace {

struct RareCaseOptions {
    MachineSettings machine;
    int rounds = 5;
    bool json = false;
};

ExitCode run_rare_cases(const RareCaseOptions& options) {
    if (!options.json) fmt::print("{}", bench::rare_case_header());
    const std::vector<bench::RareCaseRow> rows =
        measure_rare_cases(options.machine, options.rounds, [&](const bench::RareCaseRow& row) {
            if (options.json) return;
            fmt::print("{}", to_table(row));
            std::fflush(stdout); // an interrupt would lose what is still in the buffer
        });
    if (options.json) fmt::print("{}\n", to_json(rows).dump(2));
    return ExitCode::success;
}

} // namespace

Run add_rare_cases(CLI::App& app) {
    auto options = std::make_shared<RareCaseOptions>();
    app.description("Where compaction gains nothing: labs 02 and 03 on the rare cases, measured.");
    app.add_option("--repeats", options->rounds, "rounds; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_flag("--json", options->json, "print JSON instead of the table");
    add_machine_options(app, options->machine);
    app.footer("Examples:\n  raylab rare-cases\n  raylab rare-cases --repeats 15 --json\n"
               "`raylab bench --rare-cases` adds the same table to a bench.");
    return [options] { return run_rare_cases(*options); };
}

} // namespace raylab::app
