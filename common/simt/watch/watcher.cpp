#include "common/simt/watch/watcher.h"

#include "common/simt/api/device.h"
#include "common/simt/engine/block.h"
#include "common/simt/finding_text.h"
#include "common/simt/watch/say.h"
#include "common/simt/watch/say_text.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <link.h>
#include <sys/mman.h>

namespace raylab::simt::watch {

namespace {

constexpr size_t arena_bytes = size_t(64) << 30, most_shared = 99 << 10, red_zone = 4096;

// Between two allocations, so that an index that is far out does not meet the next one.
constexpr size_t least_gap = size_t(64) << 10, most_gap = size_t(64) << 20;

extern "C" char __data_start, _end; // the linker's: of the variables of the program

uintptr_t round_down(uintptr_t address) { return address & ~uintptr_t(15); }

// The calling thread's copy of the program's thread-local variables: static __shared__ variables
// and a few of the engine.
struct ThreadLocals {
    uintptr_t begin = 0;
    size_t bytes = 0;
};
ThreadLocals thread_locals() {
    ThreadLocals found;
    dl_iterate_phdr(
        [](dl_phdr_info* info, size_t, void* result) {
            for (int i = 0; i < info->dlpi_phnum; ++i)
                if (info->dlpi_phdr[i].p_type == PT_TLS)
                    *static_cast<ThreadLocals*>(result) = {uintptr_t(info->dlpi_tls_data),
                                                           info->dlpi_phdr[i].p_memsz};
            return 1; // the program comes first; libraries do not matter
        },
        &found);
    return {round_down(found.begin), found.begin + found.bytes - round_down(found.begin)};
}

// In a launch; then it ends, as a GPU would have ended it earlier.
constexpr int most_out_of_bounds = 1000;

} // namespace

Watcher& Watcher::get() {
    static Watcher* watcher = new Watcher; // host code may still run when statics are destroyed
    return *watcher;
}

Watcher::Watcher()
    : used_(least_gap), arena_(uintptr_t(map_memory(arena_bytes)), arena_bytes, Memory::global),
      symbols_(round_down(uintptr_t(&__data_start)), size_t(&_end - &__data_start) + 16,
               Memory::symbol),
      host_wrote_(symbols_.bytes),
      host_writers_(static_cast<Pc*>(map_memory((symbols_.bytes / 64 + 1) * sizeof(Pc)))) {
    const char* count = std::getenv("RAYLAB_COUNT");
    counts_traffic_ = count && std::strcmp(count, "memory") == 0;
    symbols_.allowed.set(0, symbols_.bytes, true);
    symbols_.written.set(0, symbols_.bytes, true);
}

void* Watcher::allocate(size_t bytes, size_t alignment, const Where& where) {
    used_ = (used_ + alignment - 1) / alignment * alignment;
    const size_t gap = std::clamp(bytes, least_gap, most_gap);
    if (bytes > arena_bytes - most_gap || used_ + bytes + gap > arena_bytes) return nullptr;
    void* pointer = reinterpret_cast<void*>(arena_.begin + used_);
    arena_.allowed.set(used_, bytes, true);
    allocations_[uintptr_t(pointer)] = {uintptr_t(pointer), bytes, where};
    used_ += bytes + gap;
    return pointer;
}

void Watcher::release(void* pointer, size_t bytes) {
    const size_t offset = uintptr_t(pointer) - arena_.begin;
    arena_.allowed.set(offset, bytes, false);
    allocations_[uintptr_t(pointer)].is_freed = true;
    const size_t page = 4096, first = (offset + page - 1) / page * page,
                 end = (offset + bytes) / page * page;
    if (end > first)
        madvise(reinterpret_cast<void*>(arena_.begin + first), end - first, MADV_DONTNEED);
}

const Allocation* Watcher::nearest(uintptr_t address) const {
    const auto next = allocations_.upper_bound(address);
    const auto before = next == allocations_.begin() ? next : std::prev(next);
    if (before == allocations_.end()) return nullptr;
    if (before == next || next == allocations_.end()) return &before->second;
    const uintptr_t end = before->first + before->second.bytes;
    return address < end || address - end <= next->first - address ? &before->second
                                                                   : &next->second;
}

void Watcher::wrote(const void* pointer, size_t bytes) {
    Range* range = range_of(uintptr_t(pointer));
    if (!range) return;
    const uintptr_t offset = uintptr_t(pointer) - range->begin;
    range->written.set(offset, bytes, true);
    if (range != &symbols_) return;
    host_wrote_.set(offset, bytes, false); // nor did a kernel
    for (uintptr_t word = offset / 4; word * 4 < offset + bytes; ++word) range->words[word] = {};
}

void Watcher::copied(const CopyCall& call) {
    if (arena_.has(uintptr_t(call.from))) say_unwritten_copy(call, arena_);
    wrote(call.to, call.bytes);
    concurrency_.copy(call, arena_);
}

void Watcher::begin_launch(const Launch& launch, bool prints) {
    prints_ = prints;
    out_of_bounds_ = 0;
    launch_ = &launch;
    launch_number_ = concurrency_.begin_launch(launch);
    clock_.begin_launch();
    cudaDeviceGetLimit(&stack_limit_, cudaLimitStackSize);
    depth_to_look_at_ = 2 * stack_limit_;
    auto found = statics_of_.find(&threadIdx);
    if (found == statics_of_.end()) {
        const ThreadLocals locals = thread_locals();
        found =
            statics_of_.try_emplace(&threadIdx, locals.begin, locals.bytes, Memory::shared).first;
        Range& range = found->second;
        range.allowed.set(0, range.bytes, true);
        for (const auto& [variable, bytes] : engine_variables())
            range.allowed.set(uintptr_t(variable) - range.begin, bytes, false);
    }
    statics_ = &found->second;
}

// For each kernel, over all of its launches.
void Watcher::note_traffic() {
    traffic_.end_block();
    std::map<SourcePlace, Traffic> lines;
    const std::vector<Traffic>& traffic = traffic_.by_site();
    for (uint32_t site = 1; site < traffic.size(); ++site)
        if (traffic[site].requests) // a line may be compiled more than once
            lines[place_of(races_.pc(site))] += traffic[site];
    if (!lines.empty()) add_traffic(launch_->kernel, lines);
    traffic_.clear();
}

void Watcher::end_launch() {
    races_.settle();
    if (counts_traffic_) note_traffic();
    for (const auto& key : races_.in_order()) {
        const Race& race = races_.races().at(key);
        say_race(race, races_, clock_, *launch_);
    }
    for (const auto& [site, finding] : uninitialised_)
        if (!races_.has_error_at(site))
            emit(finding); // else it came too early, which the race says
    uninitialised_.clear();
    races_.clear();
    launch_ = nullptr;
    thread_ = -1;
}

// Cooperative launches are not watched.
void Watcher::go_on(int thread) {
    thread_ = launch_ ? thread : -1;
    if (thread_ < 0) return;
    quiet_reads.run(clock_.stamp(thread), clock_.warp_stamp(thread));
    quiet_reads.last_reads = &last_reads_[size_t(thread)];
}

void Watcher::prepare_quiet_reads() {
    std::vector<Range*> ranges{&arena_, &symbols_};
    if (statics_) ranges.push_back(statics_);
    if (dynamic_) ranges.push_back(dynamic_);
    if (clock_.forgotten())
        for (Range* range : ranges) range->forget_marks();
    quiet_reads.stack = quiet_reads.shallow = {};
    quiet_reads.arena = {};
    quiet_reads.others = {};
    if (counts_traffic_) return; // every access has its cost
    quiet_reads.arena = arena_.marked();
    for (size_t i = 1; i < ranges.size(); ++i) quiet_reads.others[i - 1] = ranges[i]->marked();
}

void Watcher::begin_block(uint32_t block, int threads, void* dynamic_shared, size_t bytes) {
    if (!launch_) return;
    races_.settle();
    traffic_.end_block();
    clock_.begin_block(block, threads);
    if (statics_) statics_->written.set(0, statics_->bytes, false);
    dynamic_ = nullptr;
    if (bytes) {
        const uintptr_t begin = uintptr_t(dynamic_shared);
        dynamic_ = &dynamics_.try_emplace(begin, begin, most_shared + red_zone, Memory::shared)
                        .first->second;
        dynamic_->allowed.set(0, dynamic_->bytes, false);
        dynamic_->allowed.set(0, bytes, true);
        dynamic_->written.set(0, bytes, false);
    }
    prepare_quiet_reads();
}

void Watcher::stop_after(const Finding& finding) {
    stopped_by_ = to_text(finding);
    is_busy_ = false;
    current_block->give_up(stopped_by_, cudaErrorIllegalAddress);
}

void Watcher::count_out_of_bounds(const Finding& finding) {
    if (++out_of_bounds_ >= most_out_of_bounds) stop_after(finding);
}

void Watcher::fence() {
    if (thread_ < 0) return;
    clock_.fence(thread_);
    go_on(thread_); // with a new stamp
}

Range* Watcher::range_of(uintptr_t address) {
    if (arena_.has(address)) return &arena_;
    if (statics_ && statics_->has(address)) return statics_;
    if (dynamic_ && dynamic_->has(address)) return dynamic_;
    if (symbols_.has(address)) return &symbols_;
    return nullptr;
}

void Watcher::access(uintptr_t address, unsigned bytes, bool writes, Touch touch, Pc pc) {
    if (!current_block) // host code, of whatever thread of the operating system
        return host_access(address, bytes, writes, touch, pc);
    if (thread_ < 0 || is_busy_) return;
    const Span& stack = quiet_reads.stack;
    if (stack.has(address) && stack.has(uintptr_t(__builtin_frame_address(0))))
        return; // on its own stack
    is_busy_ = true;
    look(address, bytes, writes, touch, pc);
    is_busy_ = false;
}

// What the running thread does.
void Watcher::look(uintptr_t address, unsigned bytes, bool writes, Touch touch, Pc pc) {
    look_at_depth();
    Range* found = range_of(address);
    if (!found) return look_outside(address, writes, pc);
    Range& range = *found;
    const uintptr_t offset = address - range.begin, end = offset + bytes;
    if (found == statics_ && !range.allowed.of_word(offset / 4))
        return; // the engine's: threadIdx and its kin
    races_.settle();
    Access me{
        clock_.task(thread_), clock_.now(thread_), launch_number_, races_.site(pc), touch, false};
    if (counts_traffic_) {
        traffic_.add(me.site, thread_, address, bytes, writes, range.memory);
        if (!writes && touch == Touch::plain &&
            quiet_reads.is_quiet(range.marked(), offset, bytes)) {
            last_reads_[size_t(thread_)].add(address, pc);
            return;
        }
    }
    if (touch == Touch::plain && !writes) {
        last_reads_[size_t(thread_)].add(address, pc);
    } else if (touch == Touch::plain && range.memory != Memory::shared) {
        me.has_read = has_read(address);
    }
    bool all_unwritten = true;
    for (uintptr_t word = offset / 4; word * 4 < end; ++word) {
        unsigned mask = 15;
        if (word * 4 < offset) mask &= 15u << (offset - word * 4);
        if (end < word * 4 + 4) mask &= (1u << (end - word * 4)) - 1;
        if (mask & ~range.allowed.of_word(word))
            return say_out_of_bounds(address, bytes, writes, pc, range.memory);
        if (mask & range.written.of_word(word)) all_unwritten = false;
        if (found == &symbols_ && host_wrote_.of_word(word)) {
            say_host_variable(host_writers_[offset / 64], true, pc, writes);
            host_wrote_.set(word * 4, 4, false); // said once
        }
        if (writes) range.written.add(word, mask);
        Word& whole = range.words[word];
        range.marks[word] = 0;
        if (mask == 15 && !whole.is_split) {
            const Quiet quiet = check(range, whole, me, writes, range.begin + word * 4, 4);
            mark(range, word, quiet);
        } else {
            for (int byte = 0; byte < 4; ++byte)
                if (mask >> byte & 1)
                    check(range, range.byte_at(word, byte), me, writes,
                          range.begin + word * 4 + uintptr_t(byte), 1);
        }
    }
    if (touch != Touch::plain) {
        if (!writes || is_atomic(touch)) clock_.pick_up(thread_, address);
        if (writes) clock_.publish(thread_, address);
        go_on(thread_); // perhaps with a new stamp
    }
    if (all_unwritten && (!writes || is_atomic(touch))) {
        const uint32_t site = me.site;
        if (!uninitialised_.contains(site))
            uninitialised_.emplace(site, uninitialised(address, pc, range.memory));
        range.written.set(offset, bytes, true); // said once
    }
}

} // namespace raylab::simt::watch
