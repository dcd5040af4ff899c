// The device, streams and events (runtime.h).
#include "common/simt/runtime.h"

#include "common/simt/engine/machine.h"
#include "common/simt/engine/memory.h"
#include "common/simt/watch/events.h"

#include <chrono>

using namespace raylab::simt;
using Clock = std::chrono::steady_clock;

struct CUstream_st {};

struct CUevent_st {
    bool timed = true, recorded = false;
    Clock::time_point time{};
};

namespace {

cudaError_t null_handle(const char* what) {
    return refuse(cudaErrorInvalidResourceHandle,
                  std::string("error: the ") + what + " is null or was not created");
}

} // namespace

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

cudaError_t cudaDeviceSynchronize() {
    watch::order([](auto& order) { order.host_waits_for_all(); });
    return sticky_error();
}

cudaError_t cudaDeviceReset() {
    release_all();
    forget_errors_and_limits();
    return cudaSuccess;
}

cudaError_t cudaStreamCreate(cudaStream_t* stream) {
    return cudaStreamCreateWithFlags(stream, cudaStreamDefault);
}

cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned flags) {
    *stream = new CUstream_st;
    watch::order([&](auto& order) { order.create(*stream, !(flags & cudaStreamNonBlocking)); });
    return sticky_error();
}

cudaError_t cudaStreamDestroy(cudaStream_t stream) {
    if (!stream) return null_handle("stream");
    watch::order([&](auto& order) { order.destroy(stream); });
    delete stream;
    return sticky_error();
}

cudaError_t cudaStreamSynchronize(cudaStream_t stream) {
    watch::order([&](auto& order) { order.host_waits_for_stream(stream); });
    return sticky_error();
}

// Says that all is done, after which a program need not wait.
cudaError_t cudaStreamQuery(cudaStream_t stream) { return cudaStreamSynchronize(stream); }

cudaError_t cudaStreamWaitEvent(cudaStream_t stream, cudaEvent_t event, unsigned) {
    watch::order([&](auto& order) { order.wait(stream, event); });
    return sticky_error();
}

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

cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream) {
    if (!event) return null_handle("event");
    watch::order([&](auto& order) { order.record(event, stream); });
    event->recorded = true;
    event->time = Clock::now();
    return sticky_error();
}

cudaError_t cudaEventSynchronize(cudaEvent_t event) {
    if (!event) return null_handle("event");
    watch::order([&](auto& order) { order.host_waits_for_event(event); });
    return sticky_error();
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
