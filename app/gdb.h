// gdb, with raylab's functions for CUDA threads (app/gdb_kernels.py).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace raylab::app {

// Runs the command under gdb, which stops it at the function `stop`; the terminal is gdb's until it
// ends. `root` is raylab's tree. Throws std::runtime_error if there is no gdb.
void run_gdb(const std::filesystem::path& root, const std::string& stop,
             const std::vector<std::string>& command);

} // namespace raylab::app
