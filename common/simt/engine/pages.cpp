#include "common/simt/engine/pages.h"

#include <map>
#include <mutex>
#include <sys/mman.h>
#include <unistd.h>

namespace raylab::simt {

namespace {

constexpr size_t apart = size_t(64) << 10; // bytes, a multiple of the page's size
constexpr size_t most = 8'000;             // at a time; Linux lets a process have 65,530 mappings

struct Mapping {
    void* base;
    size_t bytes;
};

std::mutex mutex;

std::map<void*, Mapping>& mappings() {                    // by what was given
    static auto* mappings = new std::map<void*, Mapping>; // used while statics are destroyed
    return *mappings;
}

size_t mapped = 0; // bytes, without the gaps

size_t round_up(size_t bytes, size_t unit) { return (bytes + unit - 1) / unit * unit; }

} // namespace

void* take_pages(size_t bytes, size_t alignment) {
    std::lock_guard lock(mutex);
    if (mappings().size() >= most) return nullptr;
    const size_t used = round_up(bytes, alignment);
    const size_t pages = round_up(used, size_t(sysconf(_SC_PAGESIZE))), all = pages + 2 * apart;
    void* base = mmap(nullptr, all, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (base == MAP_FAILED) return nullptr;
    char* first = static_cast<char*>(base) + apart;
    if (mprotect(first, pages, PROT_READ | PROT_WRITE) != 0) {
        munmap(base, all);
        return nullptr;
    }
    void* given = first + (pages - used);
    mappings()[given] = {base, all};
    mapped += pages;
    return given;
}

bool give_back_pages(void* pointer) {
    std::lock_guard lock(mutex);
    const auto found = mappings().find(pointer);
    if (found == mappings().end()) return false;
    munmap(found->second.base, found->second.bytes);
    mapped -= found->second.bytes - 2 * apart;
    mappings().erase(found);
    return true;
}

size_t mapped_bytes() {
    std::lock_guard lock(mutex);
    return mapped;
}

} // namespace raylab::simt
