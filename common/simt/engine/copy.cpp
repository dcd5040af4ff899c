// cudaMemcpy() and cudaMemset(): both ends must be where the caller says, and long enough.
#include "common/simt/engine/machine.h"
#include "common/simt/engine/memory.h"
#include "common/simt/engine/registered.h"
#include "common/simt/engine/report.h"
#include "common/simt/watch/events.h"

#include <cstring>
#include <optional>

namespace raylab::simt {

static thread_local std::optional<cudaStream_t> stream_of_copies;

InStream::InStream(cudaStream_t stream) { stream_of_copies = stream; }
InStream::~InStream() { stream_of_copies.reset(); }

// What is wrong with one end of a copy, or nothing.
static std::string wrong_end(const char* end, const void* pointer, size_t bytes,
                             bool must_be_device, const Where& where) {
    std::string start = place(where) + ": error: the " + end;
    Target target = look_up(pointer);
    if (must_be_device && !target.is_device() && !is_registered(pointer))
        return start + " is not device memory\n  expected: a pointer from cudaMalloc() that was "
                       "not freed; check the order of the arguments and the direction";
    bool shared = target.known && target.kind == MemoryKind::managed;
    if (!must_be_device && !shared && target.is_device() && target.offset < target.bytes)
        return start + " is device memory, " + describe(target) +
               "\n  expected: host memory; check the order of the arguments and the direction";
    if (target.known && must_be_device && !target.holds(bytes))
        return start + " is " + describe(target) + ", and " + std::to_string(bytes) +
               " bytes from there leave it";
    return {};
}

} // namespace raylab::simt

using namespace raylab::simt;

cudaError_t cudaMemcpy(void* to, const void* from, size_t bytes, cudaMemcpyKind kind, Where where) {
    if (sticky_error() != cudaSuccess) return sticky_error();
    if (bytes == 0) return cudaSuccess;
    bool to_device = kind == cudaMemcpyHostToDevice || kind == cudaMemcpyDeviceToDevice;
    bool from_device = kind == cudaMemcpyDeviceToHost || kind == cudaMemcpyDeviceToDevice;
    if (kind == cudaMemcpyDefault) {
        to_device = look_up(to).is_device();
        from_device = look_up(from).is_device();
    } else if (kind < cudaMemcpyHostToHost || kind > cudaMemcpyDefault) {
        return refuse(cudaErrorInvalidMemcpyDirection, place(where) +
                                                           ": error: " + std::to_string(int(kind)) +
                                                           " is no direction of a copy");
    }
    std::string wrong = wrong_end("destination", to, bytes, to_device, where);
    if (wrong.empty()) wrong = wrong_end("source", from, bytes, from_device, where);
    if (!wrong.empty()) return refuse(cudaErrorInvalidValue, wrong);
    DeviceAccess access;
    std::memmove(to, from, bytes);
    watch::copied(to, from, bytes, where, stream_of_copies);
    return cudaSuccess;
}

cudaError_t cudaMemset(void* to, int byte, size_t bytes, Where where) {
    if (sticky_error() != cudaSuccess) return sticky_error();
    if (bytes == 0) return cudaSuccess;
    std::string wrong = wrong_end("destination", to, bytes, true, where);
    if (!wrong.empty()) return refuse(cudaErrorInvalidValue, wrong);
    DeviceAccess access;
    std::memset(to, byte, bytes);
    watch::copied(to, nullptr, bytes, where, stream_of_copies);
    return cudaSuccess;
}
