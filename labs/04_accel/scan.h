// Prefix sums by the library: out[i] = in[0] + in[1] + ... + in[i - 1].
//
// Lab 03 wrote its own and found out what CUB's is worth.
#pragma once

#include <cstdint>

namespace raylab::lab04 {

// in, out and workspace: device memory; as many numbers of workspace as the second one says.
void scan(const std::uint32_t* in, std::uint32_t* out, std::int64_t n, std::uint32_t* workspace);
std::int64_t scan_workspace(std::int64_t n);

} // namespace raylab::lab04
