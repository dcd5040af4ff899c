// The device, streams and events (runtime.h), and the names of errors.
#include "common/simt/runtime.h"

#include "common/simt/engine/machine.h"
#include "common/simt/engine/memory.h"

#include <chrono>
#include <climits>
#include <cstdio>
#include <unistd.h>

using namespace raylab::simt;
using Clock = std::chrono::steady_clock;

struct CUstream_st {};

struct CUevent_st {
    bool timed = true, recorded = false;
    Clock::time_point time{};
};

namespace {

struct ErrorText {
    cudaError_t code;
    const char *name, *text;
};

constexpr ErrorText error_texts[] = {
    {cudaSuccess, "cudaSuccess", "no error"},
    {cudaErrorInvalidValue, "cudaErrorInvalidValue", "invalid argument"},
    {cudaErrorMemoryAllocation, "cudaErrorMemoryAllocation", "out of memory"},
    {cudaErrorInvalidConfiguration, "cudaErrorInvalidConfiguration",
     "invalid configuration argument"},
    {cudaErrorInvalidSymbol, "cudaErrorInvalidSymbol", "invalid device symbol"},
    {cudaErrorInvalidMemcpyDirection, "cudaErrorInvalidMemcpyDirection",
     "invalid copy direction for memcpy"},
    {cudaErrorInsufficientDriver, "cudaErrorInsufficientDriver",
     "CUDA driver version is insufficient for CUDA runtime version"},
    {cudaErrorNoDevice, "cudaErrorNoDevice", "no CUDA-capable device is detected"},
    {cudaErrorInvalidDevice, "cudaErrorInvalidDevice", "invalid device ordinal"},
    {cudaErrorInvalidResourceHandle, "cudaErrorInvalidResourceHandle", "invalid resource handle"},
    {cudaErrorNotReady, "cudaErrorNotReady", "device not ready"},
    {cudaErrorIllegalAddress, "cudaErrorIllegalAddress",
     "an illegal memory access was encountered"},
    {cudaErrorLaunchOutOfResources, "cudaErrorLaunchOutOfResources",
     "too many resources requested for launch"},
    {cudaErrorAssert, "cudaErrorAssert", "device-side assert triggered"},
    {cudaErrorLaunchFailure, "cudaErrorLaunchFailure", "unspecified launch failure"},
    {cudaErrorNotSupported, "cudaErrorNotSupported", "operation not supported"},
};

cudaError_t null_handle(const char* what) {
    return refuse(cudaErrorInvalidResourceHandle,
                  std::string("error: the ") + what + " is null or was not created");
}

} // namespace

const char* cudaGetErrorName(cudaError_t error) {
    for (const ErrorText& entry : error_texts)
        if (entry.code == error) return entry.name;
    return "unrecognized error code";
}

const char* cudaGetErrorString(cudaError_t error) {
    for (const ErrorText& entry : error_texts)
        if (entry.code == error) return entry.text;
    return "unrecognized error code";
}

cudaError_t cudaGetDeviceCount(int* count) {
    *count = 1;
    return cudaSuccess;
}

cudaError_t cudaGetDevice(int* device) {
    *device = 0;
    return cudaSuccess;
}

cudaError_t cudaSetDevice(int device) {
    if (device == 0) return cudaSuccess;
    return refuse(cudaErrorInvalidDevice, "error: there is no device " + std::to_string(device) +
                                              "\n  expected: 0, the CPU machine");
}

cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int device) {
    if (device != 0) return cudaSetDevice(device);
    *properties = {};
    std::snprintf(properties->name, sizeof properties->name, "raylab CPU machine (%d %s)",
                  worker_count(), worker_count() == 1 ? "thread" : "threads");
    properties->totalGlobalMem = size_t(sysconf(_SC_PHYS_PAGES)) * size_t(sysconf(_SC_PAGESIZE));
    properties->sharedMemPerBlock = 48 << 10;
    properties->sharedMemPerBlockOptin = 99 << 10;
    properties->major = 7; // threads of a warp go their own ways, as from Volta on
    properties->minor = 5;
    properties->multiProcessorCount = worker_count();
    properties->warpSize = 32;
    properties->maxThreadsPerBlock = properties->maxThreadsPerMultiProcessor = 1024;
    properties->regsPerBlock = 65536;
    const int block[] = {1024, 1024, 64}, grid[] = {INT_MAX, 65535, 65535};
    for (int i = 0; i < 3; ++i) {
        properties->maxThreadsDim[i] = block[i];
        properties->maxGridSize[i] = grid[i];
    }
    return cudaSuccess;
}

cudaError_t cudaDriverGetVersion(int* version) {
    *version = 0;
    return cudaSuccess;
}

cudaError_t cudaRuntimeGetVersion(int* version) {
    *version = 0;
    return cudaSuccess;
}

cudaError_t cudaDeviceSynchronize() { return sticky_error(); }

cudaError_t cudaDeviceReset() {
    release_all();
    forget_errors_and_limits();
    return cudaSuccess;
}

cudaError_t cudaStreamCreate(cudaStream_t* stream) {
    *stream = new CUstream_st;
    return sticky_error();
}

cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned) {
    return cudaStreamCreate(stream);
}

cudaError_t cudaStreamDestroy(cudaStream_t stream) {
    if (!stream) return null_handle("stream");
    delete stream;
    return sticky_error();
}

cudaError_t cudaStreamSynchronize(cudaStream_t) { return sticky_error(); }
cudaError_t cudaStreamQuery(cudaStream_t) { return sticky_error(); }
cudaError_t cudaStreamWaitEvent(cudaStream_t, cudaEvent_t, unsigned) { return sticky_error(); }

cudaError_t cudaEventCreate(cudaEvent_t* event) {
    *event = new CUevent_st;
    return sticky_error();
}

cudaError_t cudaEventCreateWithFlags(cudaEvent_t* event, unsigned flags) {
    *event = new CUevent_st;
    (*event)->timed = !(flags & cudaEventDisableTiming);
    return sticky_error();
}

cudaError_t cudaEventDestroy(cudaEvent_t event) {
    if (!event) return null_handle("event");
    delete event;
    return sticky_error();
}

cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t) {
    if (!event) return null_handle("event");
    event->recorded = true;
    event->time = Clock::now();
    return sticky_error();
}

cudaError_t cudaEventSynchronize(cudaEvent_t event) {
    return event ? sticky_error() : null_handle("event");
}

cudaError_t cudaEventQuery(cudaEvent_t event) { return cudaEventSynchronize(event); }

cudaError_t cudaEventElapsedTime(float* milliseconds, cudaEvent_t start, cudaEvent_t end) {
    if (!start || !end) return null_handle("event");
    if (!start->recorded || !end->recorded || !start->timed || !end->timed)
        return refuse(cudaErrorInvalidResourceHandle,
                      "error: cudaEventElapsedTime(): an event was not recorded, or was made "
                      "without timing");
    *milliseconds = std::chrono::duration<float, std::milli>(end->time - start->time).count();
    return sticky_error();
}
