// ThreadSanitizer's reports of races, by the interface that debuggers use (tsan_debugging.cpp in
// compiler-rt): which instructions, by which CUDA threads, at which address.
#include "common/simt/engine/sanitizer_reports.h"

#if defined(RAYLAB_CHECK_THREAD)

#include "common/simt/engine/faults.h"
#include "common/simt/engine/findings.h"
#include "common/simt/engine/interrupted.h"
#include "common/simt/engine/memory.h"

#include <cstdint>
#include <cstdio>
#include <cstring>

extern "C" {
int __tsan_get_report_data(void* report, const char** description, int* count, int* stack_count,
                           int* mop_count, int* loc_count, int* mutex_count, int* thread_count,
                           int* unique_tid_count, void** sleep_trace, uintptr_t trace_size);
int __tsan_get_report_mop(void* report, uintptr_t index, int* tid, void** address, int* size,
                          int* write, int* atomic, void** trace, uintptr_t trace_size);
int __tsan_get_report_thread(void* report, uintptr_t index, int* tid, uint64_t* os_id, int* running,
                             const char** name, int* parent_tid, void** trace,
                             uintptr_t trace_size);
}

namespace raylab::simt {

namespace {

struct Access {
    void* address;
    int size, write, atomic;
    Fault where;
    char thread[96]; // as announce_name() was told
};

struct Race {
    Access ends[2];
};

constexpr int most_races = 512; // between two launches
Race races[most_races];
int race_count = 0;

void read_access(void* report, int index, int threads, Access& access) {
    void* trace[24] = {};
    int tid = -1;
    access = {};
    __tsan_get_report_mop(report, uintptr_t(index), &tid, &access.address, &access.size,
                          &access.write, &access.atomic, trace, 24);
    for (void* frame : trace) // return addresses
        if (frame && access.where.frame_count < access.where.frames.size())
            access.where.frames[access.where.frame_count++] = static_cast<char*>(frame) - 1;
    for (int i = 0; i < threads; ++i) {
        int its_tid = -1, running = 0, parent = 0;
        uint64_t os_id = 0;
        const char* name = nullptr;
        void* created[1] = {};
        __tsan_get_report_thread(report, uintptr_t(i), &its_tid, &os_id, &running, &name, &parent,
                                 created, 1);
        if (its_tid == tid && name) std::snprintf(access.thread, sizeof access.thread, "%s", name);
    }
}

// "thread (3,0,0) of block (0,0,0) of kernel k"
Actor actor_of(const char* name) {
    Index3 thread{}, block{};
    char kernel[96] = {};
    if (std::sscanf(name, "thread (%u,%u,%u) of block (%u,%u,%u) of kernel %95[^\n]", &thread[0],
                    &thread[1], &thread[2], &block[0], &block[1], &block[2], kernel) < 6)
        return {};
    return {kernel, block, thread};
}

std::string what(const Access& access, const char* ending) {
    return std::string(access.atomic ? "atomically " : "") + (access.write ? "write" : "read") +
           ending;
}

std::string sentence(const Race& race, bool same_line, bool same_block) {
    const Access &first = race.ends[0], &second = race.ends[1];
    const std::string bytes = std::to_string(first.size) + (first.size == 1 ? " byte" : " bytes");
    const char* nothing = ", and nothing orders the two";
    if (same_line)
        return std::string("race: two threads of ") +
               (same_block ? "a block" : "different blocks") + " are in this line, one " +
               what(first, "s") + " and the other " + what(second, "s") + " the same " + bytes +
               nothing;
    return "race: this thread " + what(first, "s") + " " + bytes + " here that another thread of " +
           (same_block ? "its block " : "another block ") + what(second, "s") + nothing;
}

std::string advice(const Race& race, bool same_line, bool same_block) {
    const bool some_atomic = race.ends[0].atomic || race.ends[1].atomic;
    if (some_atomic) return "make both accesses atomic, or let a barrier stand between them";
    if (!same_block)
        return same_line ? "use an atomic operation, or let each block have elements of its own"
                         : "blocks of one launch cannot wait for each other: use an atomic "
                           "operation, or two launches";
    return same_line ? "use an atomic operation, or let each thread have an element of its own"
                     : "let __syncthreads() stand between the two, or __syncwarp() within a warp";
}

// Memory that ends before the address: what is wrong there is not the race.
bool is_out_of_bounds(const Access& access, Finding& finding) {
    const Target target = look_up(access.address);
    if (!target.known || target.holds(size_t(access.size))) return false;
    finding.kind = "out-of-bounds";
    finding.message = "out of bounds: " + std::to_string(access.size) + " bytes at " +
                      describe(target) + " are " + (access.write ? "written" : "read");
    finding.advice = "test the index against the number of elements: if (i < n)";
    return true;
}

void record(const Race& race) {
    const Access &first = race.ends[0], &second = race.ends[1];
    Finding finding;
    finding.place = user_place(first.where);
    finding.actor = actor_of(first.thread);
    if (is_out_of_bounds(first, finding)) return record(std::move(finding));
    finding.kind = "race";
    const SourcePlace other = user_place(second.where);
    if (finding.place.line == 0 && other.line == 0) return; // of the runtime's own
    const Actor other_actor = actor_of(second.thread);
    finding.other = {other, what(second, ""), other_actor};
    const bool same_block = finding.actor.block == other_actor.block;
    const bool same_line = finding.place.file == other.file && finding.place.line == other.line;
    finding.message = sentence(race, same_line, same_block);
    finding.advice = advice(race, same_line, same_block);
    record(std::move(finding));
}

} // namespace

void record_races() {
    for (int i = 0; i < race_count; ++i) record(races[i]);
    race_count = 0;
}

} // namespace raylab::simt

// Called with the sanitizer's locks held: only notes what the report says.
extern "C" void __tsan_on_report(void* report) {
    using namespace raylab::simt;
    const char* description = nullptr;
    int count = 0, stacks = 0, accesses = 0, locations = 0, mutexes = 0, threads = 0, tids = 0;
    void* sleep[1] = {};
    __tsan_get_report_data(report, &description, &count, &stacks, &accesses, &locations, &mutexes,
                           &threads, &tids, sleep, 1);
    if (accesses < 2 || race_count == most_races) return;
    for (int end : {0, 1}) read_access(report, end, threads, races[race_count].ends[end]);
    ++race_count;
}

#endif
