// Accesses of other memory than the device's, and those of host code.
#include "common/simt/engine/block.h"
#include "common/simt/watch/say.h"
#include "common/simt/watch/say_text.h"
#include "common/simt/watch/watcher.h"

#include <algorithm>

namespace raylab::simt::watch {

namespace {

// The linker's: of the __managed__ variables, which host code may use (qualifiers.h).
extern "C" char __start_raylab_managed[] __attribute__((weak)); // NOLINT
extern "C" char __stop_raylab_managed[] __attribute__((weak));  // NOLINT

bool is_managed(uintptr_t address) {
    return address >= uintptr_t(__start_raylab_managed) &&
           address < uintptr_t(__stop_raylab_managed);
}

} // namespace

// Where stacks of blocks before were, which have given them back, others may lie now.
void Watcher::add_stack(const void* bottom, size_t bytes) {
    const uintptr_t begin = uintptr_t(bottom);
    auto old = stacks_.lower_bound(begin);
    if (old != stacks_.begin() && std::prev(old)->first + std::prev(old)->second > begin) --old;
    while (old != stacks_.end() && old->first < begin + bytes) old = stacks_.erase(old);
    stacks_[begin] = bytes;
}

// Empty if the address lies in none.
Span Watcher::stack_of(uintptr_t address) const {
    const auto next = stacks_.upper_bound(address);
    if (next == stacks_.begin()) return {};
    const Span stack{std::prev(next)->first, std::prev(next)->second};
    return stack.has(address) ? stack : Span{};
}

void Watcher::set_stack(const Span& stack) {
    const size_t looked_at = std::min(depth_to_look_at_, stack.bytes);
    quiet_reads.stack = stack;
    quiet_reads.shallow = {stack.begin + stack.bytes - looked_at, looked_at};
}

// Remembers the thread's own stack: the next access is likely there, too. A thread that meets the
// others at a barrier keeps its stack to itself; those that do not share one, one after the other.
void Watcher::look_outside(uintptr_t address, bool writes, Pc pc) {
    const Span stack = stack_of(address), own = stack_of(uintptr_t(__builtin_frame_address(0)));
    if (!stack.bytes) return say_strange_address(address, writes, pc);
    if (own.begin == stack.begin)
        set_stack(own);
    else if (own.bytes)
        say_foreign_local(writes, pc);
}

// A recursion that this computer's large stacks have room for. Calls on a GPU keep at least a
// return address and a register each, in 16 bytes; large arrays of one function lie outside of that
// limit, so calls are counted, by their frames' links.
void Watcher::count_calls(uintptr_t here) {
    const Span stack = stack_of(here);
    if (!stack.bytes) return;
    set_stack(stack);
    const uintptr_t end = stack.begin + stack.bytes;
    if (end - here <= depth_to_look_at_) return;
    depth_to_look_at_ = (end - here) / 4 * 5; // the next time
    set_stack(stack);
    std::vector<Pc> calls; // where to return
    for (uintptr_t frame = here, next; frame >= here && frame < end - 16; frame = next) {
        calls.push_back(reinterpret_cast<const Pc*>(frame)[1]);
        next = *reinterpret_cast<const uintptr_t*>(frame);
        if (next <= frame) break;
    }
    if (calls.size() <= stack_limit_ / 16) return;
    const Finding finding = too_deep(calls.size(), stack_limit_, calls[calls.size() / 2]);
    emit(finding);
    stop_after(finding);
}

void Watcher::host_access(uintptr_t address, unsigned bytes, bool writes, Touch touch, Pc pc) {
    if (symbols_.has(address)) return host_uses_symbol(address, bytes, writes, pc);
    if (!arena_.has(address)) return;
    say_host_access(address, writes, pc);
    if (writes) arena_.written.set(address - arena_.begin, bytes, true);
    // A launch that runs right now is one of another thread of the operating system.
    if (touch == Touch::plain && !launch_ && concurrency_.concerns_host())
        concurrency_.host_access(arena_, address, bytes, writes, pc);
}

// Kernels and host code see one copy of a variable here, but two on a GPU. Which variables are the
// device's is not known, so it is told where one side uses what the other has written.
void Watcher::host_uses_symbol(uintptr_t address, unsigned bytes, bool writes, Pc pc) {
    if (launch_ || is_managed(address)) return;
    const uintptr_t offset = address - symbols_.begin;
    if (Word& word = symbols_.words[offset / 4]; word.writer.site) {
        say_host_variable(pc, writes, races_.pc(word.writer.site), true);
        word.writer = {}; // said once
    }
    if (!writes) return;
    host_wrote_.set(offset, bytes, true);
    host_writers_[offset / 64] = pc;
}

void Watcher::checks_again(uintptr_t address) {
    if (thread_ < 0) return;
    for (const auto& [place, pc] : last_reads_[size_t(thread_)].reads)
        if (place == address && pc) races_.checked_again(races_.site(pc));
}

} // namespace raylab::simt::watch

extern "C" void raylab_checks_again(const volatile void* place) {
    raylab::simt::watch::Watcher::get().checks_again(uintptr_t(place));
}
