// Device memory; see memory.h. In AddressSanitizer's build it is poisoned while host code runs, and
// an error there is explained in CUDA's terms; what is left at the end is named with its file:line.
#include "common/simt/engine/memory.h"

#include "common/simt/engine/block.h"
#include "common/simt/engine/environment.h"
#include "common/simt/engine/findings.h"
#include "common/simt/engine/machine.h"
#include "common/simt/engine/pages.h"
#include "common/simt/engine/report.h"
#include "common/simt/watch/events.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <new>
#include <optional>
#include <unistd.h>

namespace raylab::simt {

namespace {

struct Allocation {
    size_t bytes;
    MemoryKind kind;
    Where where;
};

constexpr size_t alignment = 256;     // of cudaMalloc()
constexpr size_t most_freed = 10'000; // allocations that are remembered after their end

size_t physical_bytes() {
    static const size_t bytes = size_t(sysconf(_SC_PHYS_PAGES)) * size_t(sysconf(_SC_PAGESIZE));
    return bytes;
}

struct Freed {
    Allocation allocation;
    Where where;
};

const char* taker(MemoryKind kind) {
    return kind == MemoryKind::device ? "cudaFree()" : "cudaFreeHost()";
}

Finding leak(const Allocation& allocation) {
    Finding finding;
    finding.kind = "leak";
    finding.severity = Severity::warning;
    finding.place = {allocation.where.file, allocation.where.line, 0};
    finding.message = "leak: these " + std::to_string(allocation.bytes) +
                      " bytes of device memory were never freed";
    finding.advice = std::string("give them to ") + taker(allocation.kind) + " at the end";
    return finding;
}

// The watch gives memory that is never handed out twice, an ordinary build pages apart from the
// host's, so that an index out of bounds ends the kernel at its line or spoils nothing of the
// host's.
void* take_memory(size_t bytes, [[maybe_unused]] const Where& where) {
#if defined(RAYLAB_CHECK_WATCH)
    return watch::Watcher::get().allocate(bytes, alignment, where);
#else
    if (!check_build)
        if (void* pointer = take_pages(bytes, alignment)) return pointer;
#if defined(RAYLAB_CHECK_THREAD)
    bytes += alignment; // so that the end of one allocation is not the next one
#endif
    return ::operator new(bytes, std::align_val_t(alignment), std::nothrow);
#endif
}
void give_back(void* pointer, [[maybe_unused]] size_t bytes) {
#if defined(RAYLAB_CHECK_WATCH)
    watch::Watcher::get().release(pointer, bytes);
#else
    if (check_build || !give_back_pages(pointer))
        ::operator delete(pointer, std::align_val_t(alignment));
#endif
}

class Memory {
  public:
    void* allocate(size_t bytes, MemoryKind kind, const Where& where) {
        if (bytes > physical_bytes()) return nullptr; // a sanitizer's heap would end the program
        void* pointer = take_memory(bytes, where);
        if (!pointer) return nullptr;
        if (check_build) std::memset(pointer, 0xff, bytes); // uninitialised floats are NaNs
        // What host code writes there is not seen where a library does it.
        if (kind != MemoryKind::device) watch::wrote(pointer, bytes);
        add(pointer, {bytes, kind, where});
        return pointer;
    }

    bool release(void* pointer, MemoryKind kind, const Where& where) {
        std::lock_guard lock(mutex_);
        auto found = allocations_.find(uintptr_t(pointer));
        if (found == allocations_.end() || found->second.kind != kind) return false;
        allow(pointer, found->second.bytes);
        if (freed_.size() >= most_freed) freed_.clear();
        freed_.insert_or_assign(uintptr_t(pointer), Freed{found->second, where});
        give_back(pointer, found->second.bytes);
        allocations_.erase(found);
        return true;
    }

    void add(const void* pointer, const Allocation& allocation) {
        std::lock_guard lock(mutex_);
        allocations_.insert({uintptr_t(pointer), allocation});
        const uintptr_t end = uintptr_t(pointer) + allocation.bytes;
        for (auto next = freed_.lower_bound(end); next != freed_.begin();) {
            --next;
            if (next->first + next->second.allocation.bytes <= uintptr_t(pointer)) break;
            next = freed_.erase(next);
        }
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

    std::optional<std::pair<size_t, Freed>> look_up_freed(const void* pointer) {
        std::lock_guard lock(mutex_);
        auto next = freed_.upper_bound(uintptr_t(pointer));
        if (next == freed_.begin()) return {};
        --next;
        const size_t offset = uintptr_t(pointer) - next->first;
        if (offset >= next->second.allocation.bytes) return {};
        return std::pair(offset, next->second);
    }

    // The allocation that begins or ends nearest to an address outside of all: how far it is, and
    // whether the address comes after.
    struct Nearest {
        size_t distance;
        bool after;
        Allocation allocation;
    };
    std::optional<Nearest> nearest(const void* pointer) {
        std::lock_guard lock(mutex_);
        std::optional<Nearest> nearest;
        const uintptr_t address = uintptr_t(pointer);
        for (const auto& [start, allocation] : allocations_) {
            const bool after = address >= start;
            const size_t distance = after ? address - start - allocation.bytes : start - address;
            if (!nearest || distance < nearest->distance) nearest = {distance, after, allocation};
        }
        return nearest;
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
            give_back(pointer, allocation.bytes);
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
            if (print_reports())
                std::fprintf(
                    stderr,
                    "%s: error: device memory leak: these %zu bytes were never given to %s\n",
                    place(allocation.where).c_str(), allocation.bytes, taker(allocation.kind));
            record(leak(allocation));
        }
        std::fflush(nullptr);
        if (leaks) write_summary();
        if (leaks && print_reports()) std::_Exit(23); // as LeakSanitizer does
    }

  private:
    std::mutex mutex_;
    std::map<uintptr_t, Allocation> allocations_; // by first address
    std::map<uintptr_t, Freed> freed_;            // likewise, with nothing new there yet
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
    watch::order(
        [](auto& order) { order.streams_wait_for_each_other(); }); // "Implicit Synchronization"
    *pointer = memory().allocate(bytes, kind, where);
    if (*pointer) {
        count_allocation(bytes);
        return cudaSuccess;
    }
    return refuse(cudaErrorMemoryAllocation,
                  place(where) + ": error: no memory for " + std::to_string(bytes) + " bytes");
}

void check_result(const char* call, void* result, const Where& where) {
    const Target target = look_up(result);
    if (!target.known || target.kind != MemoryKind::device || target.offset >= target.bytes) return;
    warn(place(where) + ": error: host code writes device memory: the pointer that " + call +
         " gives would go to " + describe(target) +
         "\n  to do: let an array of the host take the pointers, and copy it with cudaMemcpy()");
    watch::wrote(result, sizeof(void*));
}

cudaError_t release(void* pointer, MemoryKind kind, const Where& where) {
    watch::order([](auto& order) { order.host_waits_for_all(); });
    if (!pointer || memory().release(pointer, kind, where)) return sticky_error();
    Target target = look_up(pointer);
    const std::string freed = describe_freed(pointer);
    return refuse(cudaErrorInvalidValue,
                  place(where) + ": error: " +
                      (target.known     ? "to be freed is " + describe(target)
                       : !freed.empty() ? "to be freed is what was freed before: " + freed
                                        : "the pointer to be freed is not device memory") +
                      "\n  expected: a pointer as the allocation gave it, once");
}

void register_symbol(const void* symbol, size_t bytes, const Where& where) {
    memory().add(symbol, {bytes, MemoryKind::symbol, where});
}

Target look_up(const void* pointer) { return memory().look_up(pointer); }

static std::string bytes_of(size_t bytes, MemoryKind kind, const Where& where) {
    const char* giver = kind == MemoryKind::device        ? "cudaMalloc() gave at "
                        : kind == MemoryKind::pinned_host ? "cudaMallocHost() gave at "
                                                          : "a device symbol has, used at ";
    return std::to_string(bytes) + " bytes that " + giver + place(where);
}

std::string describe(const Target& target) {
    return "byte " + std::to_string(target.offset) + " of the " +
           bytes_of(target.bytes, target.kind, target.where);
}

std::string describe_freed(const void* address) {
    const auto found = memory().look_up_freed(address);
    if (!found) return {};
    const auto& [offset, freed] = *found;
    return "byte " + std::to_string(offset) + " of the " +
           bytes_of(freed.allocation.bytes, freed.allocation.kind, freed.allocation.where) +
           " and that were freed at " + place(freed.where);
}

std::string describe_address(const void* address) {
    if (const Target target = look_up(address); target.known) return describe(target);
    if (std::string freed = describe_freed(address); !freed.empty()) return freed;
    const auto nearest = memory().nearest(address);
    if (!nearest) return "and nothing was allocated";
    return std::to_string(nearest->distance) + " bytes " + (nearest->after ? "after" : "before") +
           " the " +
           bytes_of(nearest->allocation.bytes, nearest->allocation.kind, nearest->allocation.where);
}

DeviceAccess::DeviceAccess() { memory().begin_access(); }
DeviceAccess::~DeviceAccess() { memory().end_access(); }

void release_all() { memory().release_all(); }

} // namespace raylab::simt
