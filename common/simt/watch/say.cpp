#include "common/simt/watch/say.h"

#include "common/simt/engine/block.h"
#include "common/simt/engine/findings.h"
#include "common/simt/engine/memory.h"
#include "common/simt/engine/registered.h"
#include "common/simt/engine/report.h"
#include "common/simt/engine/where_is.h"
#include "common/simt/index.h"
#include "common/simt/watch/say_text.h"
#include "common/simt/watch/watcher.h"

#include <cstdio>
#include <fstream>
#include <unordered_map>

namespace raylab::simt::watch {

namespace {

Index3 index_in(uint64_t number, dim3 shape) {
    return {unsigned(number % shape.x), unsigned(number / shape.x % shape.y),
            unsigned(number / shape.x / shape.y)};
}

Actor actor(const Launch& launch, uint32_t block, int thread) {
    return {launch.kernel, index_in(block, launch.grid), index_in(uint64_t(thread), launch.block)};
}

const char* verb(bool writes) { return writes ? "writes" : "reads"; }

// Where the memory's nearest allocation is, in words; empty if there is none near.
std::string near(uintptr_t address) {
    const Allocation* nearest = Watcher::get().nearest(address);
    if (!nearest) return {};
    const std::string memory = "the " + std::to_string(nearest->bytes) +
                               " bytes that were allocated at " + place(nearest->where);
    if (address < nearest->begin)
        return std::to_string(nearest->begin - address) + " bytes before " + memory;
    const uintptr_t offset = address - nearest->begin;
    if (offset >= nearest->bytes)
        return std::to_string(offset - nearest->bytes) + " bytes behind the end of " + memory;
    return "byte " + std::to_string(offset) + " of " + memory;
}

enum class Mapped { nothing, file, memory };

// What the operating system has at an address.
Mapped mapped_at(uintptr_t address) {
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        unsigned long first = 0, last = 0, inode = 0;
        if (std::sscanf(line.c_str(), "%lx-%lx %*s %*s %*s %lu", &first, &last, &inode) != 3)
            continue;
        if (address >= first && address < last) return inode ? Mapped::file : Mapped::memory;
    }
    return Mapped::nothing;
}

const char* what_happened(bool wrote, Touch touch) {
    if (is_atomic(touch)) return "atomic operation";
    return wrote ? "write" : "read";
}

} // namespace

Actor running_actor() {
    const Watcher& watcher = Watcher::get();
    const uint32_t block = (blockIdx.z * gridDim.y + blockIdx.y) * gridDim.x + blockIdx.x;
    return actor(watcher.launch(), block, watcher.thread());
}

std::vector<std::pair<const void*, size_t>> engine_variables() {
    return {{&threadIdx, sizeof threadIdx},         {&blockIdx, sizeof blockIdx},
            {&blockDim, sizeof blockDim},           {&gridDim, sizeof gridDim},
            {&current_block, sizeof current_block}, {&quiet_reads, sizeof quiet_reads}};
}

void say_race(const Race& race, const RaceBook& book, const BlockClock& clock,
              const Launch& launch) {
    const char* harmless = book.why_harmless(race);
    const Pc before_pc = book.pc(race.before.site), after_pc = book.pc(race.after.site);
    const uint32_t b1 = clock.block_of(race.before.task), b2 = clock.block_of(race.after.task);
    const int t1 = clock.thread_of(race.before.task), t2 = clock.thread_of(race.after.task);
    const Meeting meeting = b1 != b2             ? Meeting::blocks
                            : t1 / 32 == t2 / 32 ? Meeting::lanes
                                                 : Meeting::warps;

    Finding finding;
    finding.kind = harmless ? "benign-race" : "race";
    finding.severity = harmless ? Severity::note : Severity::error;
    finding.place = place_of(after_pc);
    finding.actor = actor(launch, b2, t2);
    finding.other =
        Finding::Other{place_of(before_pc), what_happened(race.before_wrote, race.before.touch),
                       actor(launch, b1, t1)};
    const RaceWords words =
        race_words(race, meeting, finding.place == finding.other->place, harmless);
    finding.message = words.message;
    finding.advice = words.advice;
    finding.count = std::int64_t(race.count);
    finding.mode = "watch";
    emit(finding);
}

void say_out_of_bounds(uintptr_t address, unsigned bytes, bool writes, Pc pc, Memory memory) {
    Finding finding;
    finding.place = place_of(pc);
    finding.actor = running_actor();
    finding.mode = "watch";
    if (memory == Memory::shared) {
        finding.kind = "shared-overrun";
        finding.message = std::string("the kernel ") + verb(writes) +
                          " dynamic shared memory beyond the " +
                          std::to_string(Watcher::get().launch().shared_bytes) +
                          " bytes that the launch asked for";
        finding.advice = "give the launch the number of bytes, not of elements: "
                         "k<<<grid, block, n * sizeof(float)>>>()";
    } else if (const Allocation* nearest = Watcher::get().nearest(address);
               nearest && nearest->is_freed && address - nearest->begin < nearest->bytes) {
        finding.kind = "use-after-free";
        finding.message =
            std::string("the kernel ") + verb(writes) + " memory that was freed, " + near(address);
        finding.advice = "call cudaFree() after the last kernel that uses the memory";
    } else {
        finding.kind = "out-of-bounds";
        const std::string where = near(address);
        finding.message = std::string("the kernel ") + verb(writes) + " " + std::to_string(bytes) +
                          " bytes out of bounds" + (where.empty() ? "" : ", " + where);
        finding.advice =
            "let only threads with a valid index go on: if (i < n) ...; or allocate more";
    }
    emit(finding);
    Watcher::get().count_out_of_bounds(finding);
}

Finding uninitialised(uintptr_t address, Pc pc, Memory memory) {
    Finding finding;
    finding.kind = memory == Memory::shared ? "uninitialised-shared" : "uninitialised-global";
    finding.place = place_of(pc);
    finding.actor = running_actor();
    finding.mode = "watch";
    if (memory == Memory::shared) {
        finding.message = "the kernel reads shared memory that no thread of this block has written";
        finding.advice =
            "shared memory starts with whatever was there before: write it first, then "
            "__syncthreads()";
    } else {
        const std::string where = near(address);
        finding.message = "the kernel reads device memory that nobody has written" +
                          (where.empty() ? "" : ", " + where);
        finding.advice =
            "cudaMalloc() does not clear memory: use cudaMemset() or cudaMemcpy() before "
            "the launch";
    }
    return finding;
}

void say_strange_address(uintptr_t address, bool writes, Pc pc) {
    static std::unordered_map<uintptr_t, Mapped> pages;
    const auto [page, is_new] = pages.emplace(address >> 12, Mapped::nothing);
    if (is_new && address >= 0x10000) page->second = mapped_at(address);
    if (page->second == Mapped::file) return; // a constant of the program or of a library
    if (is_registered(reinterpret_cast<const void*>(address))) return;
    Finding finding;
    finding.place = place_of(pc);
    if (finding.place.file.empty() && page->second == Mapped::memory) return; // of a header here
    finding.actor = running_actor();
    finding.mode = "watch";
    const std::string start = std::string("the kernel ") + verb(writes) + " ";
    if (address < 0x10000) {
        finding.kind = "null-pointer";
        finding.message = start + "through a null pointer";
        finding.advice = "check that cudaMalloc() was called for it and succeeded";
    } else if (page->second == Mapped::memory) {
        finding.kind = "host-memory";
        finding.message = start + "host memory";
        finding.advice =
            "copy the data to device memory with cudaMemcpy(), also what a struct points to";
    } else {
        finding.kind = "wild-address";
        const std::string where = near(address);
        finding.message =
            start + "at an address where there is no memory" + (where.empty() ? "" : ", " + where);
        finding.advice = "look at the index: it may be negative, or too large for its type";
    }
    emit(finding);
    Watcher::get().stop_after(finding);
}

} // namespace raylab::simt::watch
