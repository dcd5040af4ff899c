#include "common/simt/engine/environment.h"

#include "common/simt/engine/report.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace raylab::simt {

bool print_reports() {
    const char* reports = std::getenv("RAYLAB_REPORTS");
    return !reports || std::string(reports) != "0";
}

Options options_of_environment() {
    Options options;
    options.print_reports = print_reports();
    if (const char* workers = std::getenv("RAYLAB_WORKERS"))
        options.threads = std::clamp(std::atoi(workers), 0, 1024);
    const char* text = std::getenv("RAYLAB_ORDER");
    const std::string order = text ? text : "";
    if (order.empty() || order == "forward") return options;
    if (order == "reverse") {
        options.order = Order::reverse;
    } else if (unsigned long long seed = 1;
               order == "random" || std::sscanf(text, "random:%llu", &seed) == 1) {
        options.order = Order::random;
        options.seed = seed;
    } else {
        end_with_message("error: RAYLAB_ORDER is '" + order +
                         "'\n  expected: forward, reverse, random or random:SEED");
    }
    return options;
}

} // namespace raylab::simt
