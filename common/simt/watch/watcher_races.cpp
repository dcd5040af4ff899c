// One access against those before it of the same word.
#include "common/simt/watch/watcher.h"

namespace raylab::simt::watch {

bool Watcher::has_read(uintptr_t address) const {
    for (const auto& [place, pc] : last_reads_[size_t(thread_)].reads)
        if (place == address && pc) return true;
    return false;
}

// What lies in shared memory is gone when its block ends, the rest counts until the launch ends.
bool Watcher::is_current(const Range& range, const Access& access) const {
    return access.site && access.launch == launch_number_ &&
           (range.memory != Memory::shared || clock_.block_of(access.task) == clock_.block());
}

// Of an access that every other lane of the running thread's warp, too, comes after.
bool Watcher::all_lanes_know(const Range& range, const Access& access) const {
    return !is_current(range, access) || access.task != clock_.task(thread_) ||
           epoch_of(access.time) < epoch_of(clock_.now(thread_));
}

// Reads of single bytes pass, too, so all must have been written.
void Watcher::mark(Range& range, uintptr_t word, Quiet quiet) {
    if (quiet == Quiet::nobody || range.allowed.of_word(word) != 15 ||
        range.written.of_word(word) != 15)
        return;
    const Stamp warp = clock_.warp_stamp(thread_);
    range.marks[word] = quiet == Quiet::warp && warp != no_stamp ? warp : clock_.stamp(thread_);
}

Watcher::Quiet Watcher::check(Range& range, Word& word, const Access& me, bool writes,
                              uintptr_t address, unsigned bytes) {
    const auto races_with = [&](const Access& before) {
        return is_current(range, before) && before.task != me.task &&
               !(is_atomic(before.touch) && is_atomic(me.touch)) &&
               !clock_.knows(thread_, before.task, before.time);
    };
    const bool is_looked_at = concurrency_.concerns_launch() && range.memory != Memory::shared;
    if (is_looked_at)
        concurrency_.kernel_access(word, address, bytes, writes, me.touch, races_.pc(me.site));
    const bool races = races_with(word.writer);
    if (races) conflict(range, word.writer, true, me, writes, address, bytes);
    if (!writes) {
        const bool is_remembered = insert_reader(range, word, me);
        if (races || is_looked_at || me.touch != Touch::plain) return Quiet::nobody;
        // Another lane of the warp is ordered after the writer if this one is, but if this one is
        // the writer.
        return is_remembered || !all_lanes_know(range, word.writer) ? Quiet::thread : Quiet::warp;
    }
    for (Access& reader : word.readers) {
        if (races_with(reader)) conflict(range, reader, false, me, writes, address, bytes);
        reader = {};
    }
    word.writer = me;
    return Quiet::nobody;
}

// Whether the word remembers the reader now.
bool Watcher::insert_reader(const Range& range, Word& word, const Access& me) {
    Access &first = word.readers[0], &second = word.readers[1];
    const auto replaceable = [&](const Access& old) {
        return !is_current(range, old) || old.task == me.task ||
               (clock_.block_of(old.task) == clock_.block() &&
                clock_.knows(thread_, old.task, old.time));
    };
    const auto is_far = [&](const Access& a, const Access& b) {
        return clock_.block_of(a.task) != clock_.block_of(b.task) ||
               clock_.thread_of(a.task) / 32 != clock_.thread_of(b.task) / 32;
    };
    if (replaceable(first))
        first = me;
    else if (replaceable(second) || (!is_far(first, second) && is_far(first, me)))
        second = me;
    else
        return false;
    return true;
}

void Watcher::conflict(const Range& range, const Access& before, bool before_wrote,
                       const Access& me, bool writes, uintptr_t address, unsigned bytes) {
    Race race;
    race.before = before;
    race.after = me;
    race.before_wrote = before_wrote;
    race.after_wrote = writes;
    race.memory = range.memory;
    races_.note(race, address, bytes);
}

} // namespace raylab::simt::watch
