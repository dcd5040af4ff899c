// Prefix sums (scan): out[i] = in[0] + in[1] + ... + in[i - 1], and out[0] = 0.
//
// The sum before an element is the place it goes to when only some are kept: compaction, sorting
// and queues without atomics are all made of it. Here are six ways to one result, from the loop to
// the library. Harris, Sengupta and Owens, Parallel Prefix Sum (Scan) with CUDA, GPU Gems 3,
// chapter 39; Blelloch, Prefix Sums and Their Applications, 1990.
//
// Numbers are 32 bit and wrap like unsigned ones; lengths and indices are 64 bit, so that 2^31
// elements are as good as ten. Any length, also 0. in and out are device memory and do not overlap.
#pragma once

#include "common/render/wavefront_settings.h"
#include "common/wavefront/scan_library.h"

#include <cstdint>

namespace raylab::lab03 {

// The signature of all six. workspace: device memory of as many numbers as the scan says it needs.
using ScanFunction = void(const std::uint32_t* in, std::uint32_t* out, std::int64_t n,
                          std::uint32_t* workspace);

ScanFunction scan_serial;    // one thread: what the others must beat
ScanFunction scan_naive;     // Hillis and Steele: log n launches, n log n additions
ScanFunction scan_efficient; // Blelloch: up and down a tree in shared memory, n additions
ScanFunction scan_warp;      // shuffles within warps
using raylab::scan_library;  // CUB on a GPU, the standard library on the CPU machine
ScanFunction scan_lookback;  // Merrill and Garland: one pass, each number read and written once

// By name, and the numbers of workspace that it needs for up to n elements.
ScanFunction* scan_function(ScanKind kind);
std::int64_t scan_workspace(ScanKind kind, std::int64_t n);
std::int64_t scan_lookback_workspace(std::int64_t n);

} // namespace raylab::lab03
