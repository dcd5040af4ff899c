// The CPU machine in one of its modes: built in a folder of its own, and how it compiles a program.
#pragma once

#include "app/run/run_options.h"

#include <string>
#include <vector>

namespace raylab::app {

// How a mode is built and run.
struct Mode {
    std::string name;        // plain, bounds, races, ...
    std::string preset;      // of CMakePresets.json
    std::string flags;       // beyond those of raylab's own kernels
    double patience;         // how much longer than plain a program may take
    std::string engine = {}; // the mode whose build this one uses, or empty: its own
    std::string build() const {
        return "machine-" + (engine.empty() ? name : engine);
    } // below build/
};

const Mode& mode_named(const std::string& name);

// An engine that is built.
struct Machine {
    const Mode* mode;
    std::filesystem::path folder;   // of the build
    std::filesystem::path rewriter; // simt_rewrite
    std::string compile, link;      // commands of common/simt/program/empty.cu, for the shell
};

// Configures and builds what is not there or out of date; shows progress. Throws
// std::runtime_error: what, where, what to do.
Machine build_machine(const Tree& tree, const Mode& mode);

} // namespace raylab::app
