// Launching, the same for both machines: how many blocks, how the CPU machine is to run, and what
// the machine is called.
#pragma once

#include "common/device/device_array.h"
#include "common/render/renderer.h"
#include "common/simt/cuda.h"
#if !defined(__CUDACC__)
#include "common/simt/options.h"
#endif

#include <string>

namespace raylab {

// The number of parts of `size` things that cover n things. The last part may be incomplete.
constexpr int parts_for(std::int64_t n, int size) {
    return static_cast<int>((n + size - 1) / size);
}

// CUDA blocks of `block` threads for n threads, and the warps and lanes that these are.
constexpr int blocks_for(std::int64_t n, int block) { return parts_for(n, block); }
constexpr int warp_lanes = 32;
constexpr int warps_for(std::int64_t n) { return parts_for(n, warp_lanes); }
constexpr std::uint64_t lanes_for(std::int64_t n) {
    return static_cast<std::uint64_t>(warps_for(n)) * warp_lanes;
}

// Sets the CPU machine's worker threads and thread order. Nothing to do on a GPU.
inline void configure_machine([[maybe_unused]] const MachineSettings& machine) {
#if !defined(__CUDACC__)
    simt::Options options;
    options.threads = machine.threads;
    options.order = machine.order == ThreadOrder::forward   ? simt::Order::forward
                    : machine.order == ThreadOrder::reverse ? simt::Order::reverse
                                                            : simt::Order::random;
    options.seed = machine.order_seed;
    simt::set_options(options);
#endif
}

// "NVIDIA H100 80GB HBM3", or the CPU machine's name.
inline std::string machine_name() {
    cudaDeviceProp properties{};
    check(cudaGetDeviceProperties(&properties, 0), "cudaGetDeviceProperties");
    return properties.name;
}

} // namespace raylab
