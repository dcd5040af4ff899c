// Prefix sums by the library: out[i] = in[0] + in[1] + ... + in[i - 1], and out[0] = 0.
//
// Lab 03 writes its own beside this one, and finds out what CUB's is worth.
#pragma once

#include <cstdint>

namespace raylab {

// in, out and workspace: device memory, in and out do not overlap; of workspace as many numbers as
// the second one says. n: any length, also 0.
void scan_library(const std::uint32_t* in, std::uint32_t* out, std::int64_t n,
                  std::uint32_t* workspace);
std::int64_t scan_library_workspace(std::int64_t n);

} // namespace raylab
