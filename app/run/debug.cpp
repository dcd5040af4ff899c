#include "app/run/debug.h"

#include "app/gdb.h"
#include "app/run/build_program.h"
#include "app/run/output.h"
#include "app/run/work_folder.h"
#include "common/cli/exit_codes.h"

#include <fmt/format.h>

#include <cstdlib>

namespace raylab::app {

int debug(const Tree& tree, const RunOptions& options) {
    const WorkFolder work(options.keep);
    const Mode& mode = mode_named("gdb");
    const std::vector<std::string> sources = sources_of(options.inputs);
    const BuiltProgram built =
        build_program(tree, build_machine(tree, mode), sources, options, work.path() / mode.name);
    if (built.file.empty()) {
        fmt::print("{}", to_text({sources, {}, built.findings, built.words, {}}));
        return int(ExitCode::bad_usage);
    }
    setenv("RAYLAB_WORKERS", "1", 1); // no other CUDA thread runs while one is looked at
    const std::string order =
        options.order == "random" ? fmt::format("random:{}", options.seed) : options.order;
    if (!order.empty()) setenv("RAYLAB_ORDER", order.c_str(), 1);
    std::vector<std::string> command = {built.file.string()};
    command.insert(command.end(), options.arguments.begin(), options.arguments.end());
    run_gdb(tree.root, "main", command);
    return int(ExitCode::success);
}

} // namespace raylab::app
