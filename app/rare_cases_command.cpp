// raylab rare-cases: where a wavefront gains nothing, measured.
#include "app/commands.h"
#include "app/rare_cases.h"
#include "common/cli/progress.h"

#include <fmt/format.h>

namespace raylab::app {

namespace {

struct RareCaseOptions {
    MachineSettings machine;
    int rounds = 5;
    bool json = false;
};

ExitCode run_rare_cases(const RareCaseOptions& options) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    if (!options.json) fmt::print("{}", rare_case_header());
    Progress progress("rare cases", static_cast<int>(rare_cases().size()), "cases", 1);
    int done = 0;
    for (const RareCase& rare : rare_cases()) {
        const RareCaseRow row = measure(rare, options.machine, options.rounds);
        progress.clear();
        if (options.json)
            json.push_back(to_json(row));
        else
            fmt::print("{}", to_table(row));
        progress.update(++done);
    }
    if (options.json) fmt::print("{}\n", json.dump(2));
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
