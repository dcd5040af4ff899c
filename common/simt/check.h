// check(): no CUDA call goes unnoticed. Works with both machines.
//
//     simt::check(cudaMalloc(&pixels, bytes), "cudaMalloc(pixels)");
//     render<<<grid, block>>>(view, pixels);
//     simt::check(cudaGetLastError(), "render<<<>>>");
#pragma once

#include "common/simt/cuda.h"
#include "common/simt/where.h"

#if defined(RAYLAB_CPU_MACHINE)
#include "common/simt/options.h"
#endif

#include <stdexcept>
#include <string>

namespace raylab::simt {

// A CUDA call that failed: what() names the call, its file and line, and CUDA's words.
class DeviceError : public std::runtime_error {
  public:
    DeviceError(cudaError_t code, const std::string& text) : std::runtime_error(text), code(code) {}
    cudaError_t code;
};

// Whether `error` says that this machine has no GPU, or no driver for it.
inline bool means_no_gpu(cudaError_t error) {
    return error == cudaErrorInsufficientDriver || error == cudaErrorNoDevice;
}

// Throws DeviceError unless `error` is cudaSuccess. `call` is what was called, for the message.
inline void check(cudaError_t error, const std::string& call, Where where = Where::here()) {
    if (error == cudaSuccess) return;
    std::string text = std::string(where.file) + ":" + std::to_string(where.line) + ": " + call +
                       " failed: " + cudaGetErrorString(error) + " (" + cudaGetErrorName(error) +
                       ", code " + std::to_string(int(error)) + ")";
    if (means_no_gpu(error))
        text += "\nno NVIDIA GPU or driver was found on this machine: use the CPU machine "
                "(build with the preset 'cpu'), which runs the same kernels";
#if defined(RAYLAB_CPU_MACHINE)
    if (std::string report = last_report(); !report.empty()) text += "\n" + report;
#endif
    throw DeviceError(error, text);
}

} // namespace raylab::simt
