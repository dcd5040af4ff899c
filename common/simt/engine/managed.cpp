// Managed and registered memory; see api/managed.h. And cudaFree(), which takes both kinds of
// device memory.
#include "common/simt/api/managed.h"

#include "common/simt/engine/machine.h"
#include "common/simt/engine/memory.h"
#include "common/simt/engine/registered.h"
#include "common/simt/engine/report.h"

#include <atomic>
#include <map>
#include <mutex>
#include <unistd.h>

using namespace raylab::simt;

namespace {

std::mutex mutex;

std::atomic<bool> any_memory{false};

std::map<const char*, size_t>& ranges() { // by first byte
    static std::map<const char*, size_t> ranges;
    return ranges;
}

} // namespace

namespace raylab::simt {

bool take_any_memory() { return any_memory = true; }

bool is_registered(const void* pointer) {
    if (any_memory) return true;
    std::lock_guard lock(mutex);
    auto address = static_cast<const char*>(pointer);
    auto next = ranges().upper_bound(address);
    if (next == ranges().begin()) return false;
    auto [first, bytes] = *--next;
    return address < first + bytes;
}

cudaError_t release_device(void* pointer, const Where& where) {
    Target target = pointer ? look_up(pointer) : Target{};
    bool managed = target.known && target.kind == MemoryKind::managed;
    return release(pointer, managed ? MemoryKind::managed : MemoryKind::device, where);
}

} // namespace raylab::simt

cudaError_t cudaHostRegister(void* host, size_t bytes, unsigned, Where where) {
    if (!host || bytes == 0)
        return refuse(cudaErrorInvalidValue,
                      place(where) + ": error: cudaHostRegister() is given no memory");
    if ((is_registered(host) && !any_memory) || look_up(host).holds(1))
        return refuse(cudaErrorHostMemoryAlreadyRegistered,
                      place(where) + ": error: this memory is registered already");
    std::lock_guard lock(mutex);
    ranges().insert({static_cast<char*>(host), bytes});
    return sticky_error();
}

cudaError_t cudaHostUnregister(void* host, Where where) {
    std::lock_guard lock(mutex);
    if (ranges().erase(static_cast<char*>(host)) == 0)
        return refuse(cudaErrorHostMemoryNotRegistered,
                      place(where) + ": error: this memory was not registered");
    return sticky_error();
}

cudaError_t cudaHostGetFlags(unsigned* flags, void*) {
    *flags = cudaHostAllocMapped;
    return sticky_error();
}

cudaError_t cudaMemPrefetchAsync(const void*, size_t, int, cudaStream_t) { return sticky_error(); }
cudaError_t cudaMemAdvise(const void*, size_t, cudaMemoryAdvise, int) { return sticky_error(); }
cudaError_t cudaStreamAttachMemAsync(cudaStream_t, void*, size_t, unsigned) {
    return sticky_error();
}

cudaError_t cudaMemGetInfo(size_t* free_bytes, size_t* total_bytes) {
    size_t page = size_t(sysconf(_SC_PAGESIZE));
    *total_bytes = size_t(sysconf(_SC_PHYS_PAGES)) * page;
#if defined(_SC_AVPHYS_PAGES)
    *free_bytes = size_t(sysconf(_SC_AVPHYS_PAGES)) * page;
#else
    *free_bytes = *total_bytes / 2;
#endif
    return sticky_error();
}

cudaError_t cudaPointerGetAttributes(cudaPointerAttributes* attributes, const void* pointer) {
    Target target = look_up(pointer);
    auto address = const_cast<void*>(pointer);
    *attributes = {cudaMemoryTypeUnregistered, cudaInvalidDeviceId, nullptr, address};
    bool inside = target.known && target.offset < target.bytes;
    if ((is_registered(pointer) && !any_memory) ||
        (inside && target.kind == MemoryKind::pinned_host))
        *attributes = {cudaMemoryTypeHost, 0, address, address};
    else if (inside && target.kind == MemoryKind::managed)
        *attributes = {cudaMemoryTypeManaged, 0, address, address};
    else if (inside)
        *attributes = {cudaMemoryTypeDevice, 0, address, nullptr};
    return sticky_error();
}
