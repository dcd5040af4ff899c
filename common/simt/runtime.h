// The CUDA runtime of the CPU machine: the device, streams and events.
//
// Everything a stream is given is done at once, in the order of the calls. That is one of the
// orders a GPU may choose, so a program that is right on a GPU is right here; a forgotten
// synchronisation changes nothing here, but the watch tells it (watch/concurrency.h).
#pragma once

#include "common/simt/device_prop.h"
#include "common/simt/index.h"
#include "common/simt/runtime_errors.h"
#include "common/simt/runtime_memory.h"

// The device.
cudaError_t cudaGetDeviceCount(int* count);
cudaError_t cudaGetDevice(int* device);
cudaError_t cudaSetDevice(int device);
cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int device);
cudaError_t cudaDriverGetVersion(int* version);
cudaError_t cudaRuntimeGetVersion(int* version);
cudaError_t cudaDeviceSynchronize();
cudaError_t cudaDeviceReset(); // frees all device memory and forgets every error

// Kernels.
enum cudaFuncAttribute {
    cudaFuncAttributeMaxDynamicSharedMemorySize = 8,
    cudaFuncAttributePreferredSharedMemoryCarveout = 9,
};

namespace raylab::simt {
cudaError_t set_attribute(const void* kernel, cudaFuncAttribute attribute, int value);
} // namespace raylab::simt

// Lets a kernel have more than 48 KiB of dynamic shared memory, up to 99 KiB.
template <class Kernel>
inline cudaError_t cudaFuncSetAttribute(Kernel* kernel, cudaFuncAttribute attribute, int value) {
    return raylab::simt::set_attribute(reinterpret_cast<const void*>(kernel), attribute, value);
}

// A worker runs one block at a time, and any size of block equally well.
template <class Kernel>
inline cudaError_t cudaOccupancyMaxActiveBlocksPerMultiprocessor(int* blocks, Kernel, int, size_t) {
    *blocks = 1;
    return cudaSuccess;
}
template <class Kernel>
inline cudaError_t cudaOccupancyMaxPotentialBlockSize(int* min_grid, int* block, Kernel, size_t = 0,
                                                      int limit = 0) {
    cudaDeviceProp properties;
    cudaGetDeviceProperties(&properties, 0);
    *min_grid = properties.multiProcessorCount;
    *block = limit > 0 && limit < 256 ? limit : 256;
    return cudaSuccess;
}

// Streams.
inline constexpr unsigned cudaStreamDefault = 0, cudaStreamNonBlocking = 1;
cudaError_t cudaStreamCreate(cudaStream_t* stream);
cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned flags);
cudaError_t cudaStreamDestroy(cudaStream_t stream);
cudaError_t cudaStreamSynchronize(cudaStream_t stream);
cudaError_t cudaStreamQuery(cudaStream_t stream);

// Events: moments in a stream, and the milliseconds between two of them.
using cudaEvent_t = struct CUevent_st*;
inline constexpr unsigned cudaEventDefault = 0, cudaEventDisableTiming = 2;
cudaError_t cudaEventCreate(cudaEvent_t* event);
cudaError_t cudaEventCreateWithFlags(cudaEvent_t* event, unsigned flags);
cudaError_t cudaEventDestroy(cudaEvent_t event);
cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream = nullptr);
cudaError_t cudaEventSynchronize(cudaEvent_t event);
cudaError_t cudaEventQuery(cudaEvent_t event);
cudaError_t cudaEventElapsedTime(float* milliseconds, cudaEvent_t start, cudaEvent_t end);
cudaError_t cudaStreamWaitEvent(cudaStream_t stream, cudaEvent_t event, unsigned flags = 0);
