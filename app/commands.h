// The commands, one file each.
#pragma once

#include "app/options.h"

namespace raylab::app {

Run add_demo(CLI::App& app);
Run add_render(CLI::App& app);
Run add_debug(CLI::App& app);
Run add_compare(CLI::App& app);
Run add_bench(CLI::App& app);
Run add_bench_rays(CLI::App& app);
Run add_rare_cases(CLI::App& app);
Run add_reference(CLI::App& app);
Run add_scenes(CLI::App& app);
Run add_export(CLI::App& app);
Run add_import(CLI::App& app);

} // namespace raylab::app
