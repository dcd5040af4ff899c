// Kernels as things: their attributes, how many blocks fit, and launches without <<<>>>.
#pragma once

#include "common/simt/api/device.h"
#include "common/simt/launch.h"

#include <string>

struct cudaFuncAttributes {
    size_t sharedSizeBytes, constSizeBytes, localSizeBytes;
    int maxThreadsPerBlock, numRegs, ptxVersion, binaryVersion, cacheModeCA,
        maxDynamicSharedSizeBytes, preferredShmemCarveout;
};

namespace raylab::simt {

cudaError_t get_attributes(cudaFuncAttributes* attributes, const void* kernel);

// An extern __shared__ array that is declared outside of functions: in each kernel a pointer to the
// block's dynamic shared memory.
template <class T> struct DynamicShared {
    operator T*() const { return dynamic_shared<T>(); }
    template <class U> explicit operator U*() const {
        return static_cast<U*>(dynamic_shared_memory());
    }
};

// The text of a call's arguments, by which reports name the kernel.
struct CallText {
    const char* text;
};
std::string first_argument(CallText call);

// CUDA takes the address of the kernel and of each argument, without their types. The rewriter
// strips the cast that most programs write in front of the kernel, and so it is known here.
template <class... Params>
inline cudaError_t launch_by_address(CallText text, void (*kernel)(Params...), dim3 grid,
                                     dim3 block, void** arguments, size_t shared_bytes,
                                     bool cooperative, cudaStream_t stream, Where where) {
    std::string name = first_argument(text);
    Launch launch{name.c_str(), where.file, where.line,   reinterpret_cast<const void*>(kernel),
                  grid,         block,      shared_bytes, cooperative,
                  stream};
    [&]<size_t... I>(std::index_sequence<I...>) {
        run_with(
            launch, [kernel](const Params&... p) { call_kernel(kernel, p...); },
            *static_cast<std::remove_cv_t<Params>*>(arguments[I])...);
    }
    (std::index_sequence_for<Params...>{});
    return cudaPeekAtLastError();
}

// A kernel that came as void*.
cudaError_t kernel_without_type(const char* call, Where where);

} // namespace raylab::simt

template <class Kernel>
inline cudaError_t cudaFuncGetAttributes(cudaFuncAttributes* attributes, Kernel* kernel) {
    return raylab::simt::get_attributes(attributes, reinterpret_cast<const void*>(kernel));
}
template <class Kernel> inline cudaError_t cudaFuncSetCacheConfig(Kernel*, cudaFuncCache) {
    return cudaDeviceSynchronize();
}
template <class Kernel>
inline cudaError_t cudaFuncSetSharedMemConfig(Kernel*, cudaSharedMemConfig) {
    return cudaDeviceSynchronize();
}

// A worker runs one block at a time, whatever its size (runtime.h).
inline constexpr unsigned cudaOccupancyDefault = 0, cudaOccupancyDisableCachingOverride = 1;
template <class Kernel>
inline cudaError_t
cudaOccupancyMaxActiveBlocksPerMultiprocessorWithFlags(int* blocks, Kernel kernel, int threads,
                                                       size_t shared_bytes, unsigned) {
    return cudaOccupancyMaxActiveBlocksPerMultiprocessor(blocks, kernel, threads, shared_bytes);
}
template <class Kernel>
inline cudaError_t cudaOccupancyMaxPotentialBlockSizeWithFlags(int* grid, int* block, Kernel kernel,
                                                               size_t shared_bytes = 0,
                                                               int limit = 0, unsigned = 0) {
    return cudaOccupancyMaxPotentialBlockSize(grid, block, kernel, shared_bytes, limit);
}
template <class Kernel, class SharedBytes>
inline cudaError_t cudaOccupancyMaxPotentialBlockSizeVariableSMem(int* grid, int* block,
                                                                  Kernel kernel, SharedBytes,
                                                                  int limit = 0) {
    return cudaOccupancyMaxPotentialBlockSize(grid, block, kernel, size_t(0), limit);
}
template <class Kernel>
inline cudaError_t cudaOccupancyAvailableDynamicSMemPerBlock(size_t* bytes, Kernel, int, int) {
    *bytes = 48 << 10;
    return cudaDeviceSynchronize();
}

template <class... Params>
inline cudaError_t cudaLaunchKernel(raylab::simt::CallText text, void (*kernel)(Params...),
                                    dim3 grid, dim3 block, void** arguments,
                                    size_t shared_bytes = 0, cudaStream_t stream = nullptr,
                                    raylab::simt::Where where = raylab::simt::Where::here()) {
    return raylab::simt::launch_by_address(text, kernel, grid, block, arguments, shared_bytes,
                                           false, stream, where);
}
// All blocks of the grid run at the same time, and may wait for each other: grid_group::sync().
template <class... Params>
inline cudaError_t
cudaLaunchCooperativeKernel(raylab::simt::CallText text, void (*kernel)(Params...), dim3 grid,
                            dim3 block, void** arguments, size_t shared_bytes = 0,
                            cudaStream_t stream = nullptr,
                            raylab::simt::Where where = raylab::simt::Where::here()) {
    return raylab::simt::launch_by_address(text, kernel, grid, block, arguments, shared_bytes, true,
                                           stream, where);
}
inline cudaError_t cudaLaunchKernel(raylab::simt::CallText, const void*, dim3, dim3, void**,
                                    size_t = 0, cudaStream_t = nullptr,
                                    raylab::simt::Where where = raylab::simt::Where::here()) {
    return raylab::simt::kernel_without_type("cudaLaunchKernel()", where);
}
inline cudaError_t
cudaLaunchCooperativeKernel(raylab::simt::CallText, const void*, dim3, dim3, void**, size_t = 0,
                            cudaStream_t = nullptr,
                            raylab::simt::Where where = raylab::simt::Where::here()) {
    return raylab::simt::kernel_without_type("cudaLaunchCooperativeKernel()", where);
}

#define cudaLaunchKernel(...) cudaLaunchKernel(raylab::simt::CallText{#__VA_ARGS__}, __VA_ARGS__)
#define cudaLaunchCooperativeKernel(...)                                                           \
    cudaLaunchCooperativeKernel(raylab::simt::CallText{#__VA_ARGS__}, __VA_ARGS__)
