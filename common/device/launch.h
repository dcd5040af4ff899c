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

// Blocks of `block` threads that cover n threads; the last may overhang.
constexpr int blocks_for(std::int64_t n, int block) {
    return static_cast<int>((n + block - 1) / block);
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
