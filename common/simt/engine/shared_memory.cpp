// Dynamic shared memory; see shared_memory.h.
#include "common/simt/engine/shared_memory.h"

#include <cstring>
#include <new>
#include <sys/mman.h>

namespace raylab::simt {

constexpr size_t unit = 16; // bytes: the alignment

#if defined(RAYLAB_CHECK_ADDRESS)

SharedMemory::~SharedMemory() = default;

bool SharedMemory::resize(size_t bytes) {
    const size_t size = (bytes + unit - 1) / unit * unit;
    if (size != (bytes_ + unit - 1) / unit * unit) heap_.reset(new (std::nothrow) char[size]);
    if (size > 0 && !heap_) return false;
    if (size == 0) heap_.reset();
    data_ = heap_.get();
    bytes_ = bytes;
    if (size > 0) std::memset(data_, 0xff, size);
    return true;
}

bool SharedMemory::is_overrun(const void*) const { return false; }

#else

constexpr size_t usable = size_t(128) << 10; // more than any launch may ask for
constexpr size_t guard = size_t(1) << 20;    // virtual memory only

SharedMemory::~SharedMemory() {
    if (end_) munmap(end_ - usable, usable + guard);
}

bool SharedMemory::resize(size_t bytes) {
    bytes_ = bytes;
    if (bytes == 0) return true;
    if (bytes > usable) return false;
    if (!end_) {
        void* memory = mmap(nullptr, usable + guard, PROT_NONE,
                            MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (memory == MAP_FAILED) return false;
        if (mprotect(memory, usable, PROT_READ | PROT_WRITE) != 0) {
            munmap(memory, usable + guard);
            return false;
        }
        end_ = static_cast<char*>(memory) + usable;
    }
    const size_t size = (bytes + unit - 1) / unit * unit;
    data_ = end_ - size;
    if (check_build) std::memset(data_, 0xff, size);
    return true;
}

bool SharedMemory::is_overrun(const void* address) const {
    const auto byte = static_cast<const char*>(address);
    return end_ && byte >= end_ && byte < end_ + guard;
}

#endif

} // namespace raylab::simt
