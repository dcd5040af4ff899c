// The machine and the programs with which a bench was run. Without them no figure can be repeated.
#pragma once

#include <string>

namespace raylab::bench {

struct Machine {
    std::string date;     // UTC, "2026-11-22 08:30"
    std::string cpu;      // model name
    int cores = 0;        // that this process may use
    double load = 0;      // of the last minute, before the first run
    std::string compiler; // name and version
    std::string flags;    // of the build
    std::string commit;   // "c7a299f01234", or empty outside a git checkout
    bool changed = false; // tracked files differ from that commit
};

Machine this_machine();

// One line for people.
std::string to_string(const Machine& machine);

} // namespace raylab::bench
