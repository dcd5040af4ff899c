// One access against those before it of the same word.
#include "common/simt/watch/watcher.h"

namespace raylab::simt::watch {

bool Watcher::has_read(uintptr_t address) const {
    for (const auto& [place, site] : last_reads_[size_t(thread_)].reads)
        if (place == address && site) return true;
    return false;
}

// What lies in shared memory is gone when its block ends, the rest counts until the launch ends.
bool Watcher::is_current(const Range& range, const Access& access) const {
    return access.site && access.launch == launch_number_ &&
           (range.memory != Memory::shared || clock_.block_of(access.task) == clock_.block());
}

void Watcher::check(Range& range, Word& word, const Access& me, bool writes, uintptr_t address,
                    unsigned bytes) {
    const auto races_with = [&](const Access& before) {
        return is_current(range, before) && before.task != me.task &&
               !(is_atomic(before.touch) && is_atomic(me.touch)) &&
               !clock_.knows(thread_, before.task, before.time);
    };
    if (concurrency_.concerns_launch() && range.memory != Memory::shared)
        concurrency_.kernel_access(word, address, bytes, writes, me.touch, races_.pc(me.site));
    if (races_with(word.writer)) conflict(range, word.writer, true, me, writes, address, bytes);
    if (!writes) {
        insert_reader(range, word, me);
        return;
    }
    for (Access& reader : word.readers) {
        if (races_with(reader)) conflict(range, reader, false, me, writes, address, bytes);
        reader = {};
    }
    word.writer = me;
}

void Watcher::insert_reader(const Range& range, Word& word, const Access& me) {
    Access &first = word.readers[0], &second = word.readers[1];
    const auto replaceable = [&](const Access& old) {
        return !is_current(range, old) || old.task == me.task ||
               (clock_.block_of(old.task) == clock_.block() &&
                clock_.knows(thread_, old.task, old.time));
    };
    const auto is_far = [&](const Access& a, const Access& b) {
        return clock_.block_of(a.task) != clock_.block_of(b.task) || a.task / 32 != b.task / 32;
    };
    if (replaceable(first))
        first = me;
    else if (replaceable(second) || (!is_far(first, second) && is_far(first, me)))
        second = me;
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
