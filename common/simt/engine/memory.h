// Which memory is the device's: every allocation, where it was made, and who may look at it now.
#pragma once

#include "common/simt/runtime_memory.h"

#include <string>

namespace raylab::simt {

// What a pointer points to.
struct Target {
    bool known = false; // in one of the allocations, or just past its end
    MemoryKind kind{};
    size_t offset = 0, bytes = 0; // of the pointer in the allocation, and the allocation's size
    Where where;
    bool holds(size_t count) const { return count <= bytes - offset; }
    // Device memory and symbols, which host code must not touch.
    bool is_device() const { return known && kind != MemoryKind::pinned_host; }
};

Target look_up(const void* pointer);

// "byte 12 of the 400 bytes that cudaMalloc() gave at f.cu:33"
std::string describe(const Target& target);

// "byte 12 of the 400 bytes that cudaMalloc() gave at f.cu:33 and cudaFree() took at f.cu:40", if
// the address was in such memory, which was not given out again since; else nothing.
std::string describe_freed(const void* address);

// What is at, or nearest to, an address that cannot be used: "4 bytes after the 400 bytes that
// ...".
std::string describe_address(const void* address);

// While one of these lives, AddressSanitizer lets its thread use device memory.
class DeviceAccess {
  public:
    DeviceAccess();
    ~DeviceAccess();
    DeviceAccess(const DeviceAccess&) = delete;
    DeviceAccess& operator=(const DeviceAccess&) = delete;
};

// cudaDeviceReset(): frees every allocation.
void release_all();

} // namespace raylab::simt
