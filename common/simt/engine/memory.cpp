// Device memory; see memory.h. In AddressSanitizer's build it is poisoned while host code runs, and
// an error there is explained in CUDA's terms; what is left at the end is named with its file:line.
#include "common/simt/engine/memory.h"

#include "common/simt/engine/block.h"
#include "common/simt/engine/findings.h"
#include "common/simt/engine/machine.h"
#include "common/simt/engine/report.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <new>

namespace raylab::simt {

namespace {

struct Allocation {
    size_t bytes;
    MemoryKind kind;
    Where where;
};

constexpr size_t alignment = 256; // of cudaMalloc()

class Memory {
  public:
    void* allocate(size_t bytes, MemoryKind kind, const Where& where) {
        void* pointer = ::operator new(bytes, std::align_val_t(alignment), std::nothrow);
        if (!pointer) return nullptr;
        if (check_build) std::memset(pointer, 0xff, bytes); // uninitialised floats are NaNs
        add(pointer, {bytes, kind, where});
        return pointer;
    }

    bool release(void* pointer, MemoryKind kind) {
        std::lock_guard lock(mutex_);
        auto found = allocations_.find(uintptr_t(pointer));
        if (found == allocations_.end() || found->second.kind != kind) return false;
        allow(pointer, found->second.bytes);
        allocations_.erase(found);
        ::operator delete(pointer, std::align_val_t(alignment));
        return true;
    }

    void add(const void* pointer, const Allocation& allocation) {
        std::lock_guard lock(mutex_);
        allocations_.insert({uintptr_t(pointer), allocation});
        if (allocation.kind == MemoryKind::device && accesses_ == 0)
            forbid(pointer, allocation.bytes);
    }

    Target look_up(const void* pointer) {
        std::lock_guard lock(mutex_);
        auto next = allocations_.upper_bound(uintptr_t(pointer));
        if (next == allocations_.begin()) return {};
        const auto& [start, allocation] = *--next;
        size_t offset = uintptr_t(pointer) - start;
        if (offset > allocation.bytes) return {};
        return {true, allocation.kind, offset, allocation.bytes, allocation.where};
    }

    void begin_access() {
        std::lock_guard lock(mutex_);
        if (accesses_++ > 0 || !check_build) return;
        for (auto& [start, allocation] : allocations_)
            allow(reinterpret_cast<void*>(start), allocation.bytes);
    }

    void end_access() {
        std::lock_guard lock(mutex_);
        if (--accesses_ > 0 || !check_build) return;
        for (auto& [start, allocation] : allocations_)
            if (allocation.kind == MemoryKind::device)
                forbid(reinterpret_cast<void*>(start), allocation.bytes);
    }

    void release_all() {
        std::lock_guard lock(mutex_);
        for (auto& [start, allocation] : allocations_) {
            if (allocation.kind == MemoryKind::symbol) continue;
            auto pointer = reinterpret_cast<void*>(start);
            allow(pointer, allocation.bytes);
            ::operator delete(pointer, std::align_val_t(alignment));
        }
        allocations_.clear();
    }

    // Names what the program never freed, which in a check build is an error.
    ~Memory() {
        if (!check_build) return;
        int leaks = 0;
        for (auto& [start, allocation] : allocations_) {
            if (allocation.kind == MemoryKind::symbol) continue;
            ++leaks;
            std::fprintf(stderr,
                         "%s: error: device memory leak: these %zu bytes were never given to %s\n",
                         place(allocation.where).c_str(), allocation.bytes,
                         allocation.kind == MemoryKind::device ? "cudaFree()" : "cudaFreeHost()");
        }
        std::fflush(nullptr);
        if (leaks) std::_Exit(23); // as LeakSanitizer does
    }

  private:
    std::mutex mutex_;
    std::map<uintptr_t, Allocation> allocations_; // by first address
    int accesses_ = 0;
};

Memory& memory() {
    static Memory memory;
    return memory;
}

} // namespace

cudaError_t allocate(void** pointer, size_t bytes, MemoryKind kind, const Where& where) {
    if (sticky_error() != cudaSuccess) return sticky_error();
    if (bytes == 0) return cudaSuccess;
    *pointer = memory().allocate(bytes, kind, where);
    if (*pointer) {
        count_allocation(bytes);
        return cudaSuccess;
    }
    return refuse(cudaErrorMemoryAllocation,
                  place(where) + ": error: no memory for " + std::to_string(bytes) + " bytes");
}

cudaError_t release(void* pointer, MemoryKind kind, const Where& where) {
    if (!pointer || memory().release(pointer, kind)) return sticky_error();
    Target target = look_up(pointer);
    return refuse(cudaErrorInvalidValue,
                  place(where) + ": error: " +
                      (target.known
                           ? "to be freed is " + describe(target)
                           : "the pointer to be freed is not, or no longer, device memory") +
                      "\n  expected: a pointer as the allocation gave it, once");
}

void register_symbol(const void* symbol, size_t bytes, const Where& where) {
    memory().add(symbol, {bytes, MemoryKind::symbol, where});
}

Target look_up(const void* pointer) { return memory().look_up(pointer); }

std::string describe(const Target& target) {
    const char* giver = target.kind == MemoryKind::device        ? "cudaMalloc() gave at "
                        : target.kind == MemoryKind::pinned_host ? "cudaMallocHost() gave at "
                                                                 : "a device symbol has, used at ";
    return "byte " + std::to_string(target.offset) + " of the " + std::to_string(target.bytes) +
           " bytes that " + giver + place(target.where);
}

DeviceAccess::DeviceAccess() { memory().begin_access(); }
DeviceAccess::~DeviceAccess() { memory().end_access(); }

void release_all() { memory().release_all(); }

} // namespace raylab::simt

#if defined(RAYLAB_CHECK_ADDRESS)

// AddressSanitizer calls this before it prints an error: say what it means in CUDA's terms.
extern "C" void __asan_on_error() {
    using namespace raylab::simt;
    void* address = __asan_get_report_address();
    Target target = look_up(address);
    std::string text = "\n";
    if (current_block)
        text += "raylab: the memory error below is in " + current_block->running() + "\n";
    else if (target.is_device() && target.kind == MemoryKind::device)
        text += "raylab: host code dereferenced a device pointer: use cudaMemcpy()\n";
    if (target.known) text += "raylab: the address is " + describe(target) + "\n";
    std::fputs(text.c_str(), stderr);
}

#endif
