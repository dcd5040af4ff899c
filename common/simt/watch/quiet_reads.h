// The short way of the watch: a plain read that would teach it nothing, as almost all are.
//
// A stamp is a number. A thread has the same one until it learns what others did, or they can learn
// what it did: until its next barrier, meeting of lanes, fence or flag (block_clock.h). The lanes
// of a warp have one more in common, as long as they know the same. Each word of memory has a mark,
// the stamp of whom it is quiet for: a full look at a read has found nothing, and a second read by
// that thread, or the first by another lane of that warp, would change neither what is found nor
// what is remembered. A write to the word takes the mark away. Ranges and stamps are those of the
// thread of the operating system that runs the block.
#pragma once

#include "common/simt/watch/knowledge.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace raylab::simt::watch {

using Pc = const void*; // the instruction behind an access

// The last plain reads of one thread, in a ring.
struct LastReads {
    std::array<std::pair<uintptr_t, Pc>, 4> reads{}; // address, place
    unsigned next = 0;
    void add(uintptr_t address, Pc pc) { reads[next++ % reads.size()] = {address, pc}; }
};

// Addresses from `begin` on.
struct Span {
    uintptr_t begin = 0;
    size_t bytes = 0;
    bool has(uintptr_t address) const { return address - begin < bytes; }
};

struct MarkedSpan {
    Span span;
    const Stamp* marks = nullptr; // a word of four bytes each
};

struct QuietReads {
    Stamp thread = no_stamp, warp = no_stamp; // of the running thread; none while the engine runs
    LastReads* last_reads = nullptr;          // its own
    Span stack;   // its own, or that of a thread before: then its frames do not lie there
    Span shallow; // of this stack: frames that need no look at the depth of the recursion
    MarkedSpan arena;
    std::array<MarkedSpan, 3> others; // shared memory, variables

    void run(Stamp of_thread, Stamp of_warp) {
        thread = of_thread;
        warp = of_warp;
    }
    void stop() { run(no_stamp, no_stamp); }

    bool is_quiet(const MarkedSpan& where, uintptr_t offset, unsigned bytes) const {
        for (uintptr_t word = offset / 4; word <= (offset + bytes - 1) / 4; ++word) {
            const Stamp mark = where.marks[word];
            if (mark != warp && mark != thread) return false;
        }
        return true;
    }
    // Whether a read needs no look. `here`: the frame of the function that asks.
    bool passes(uintptr_t address, unsigned bytes, uintptr_t here, Pc pc) const {
        if (!shallow.has(here)) return false;
        const MarkedSpan* where = &arena;
        if (!arena.span.has(address)) {
            if (stack.has(address)) return true;
            where = others.data();
            while (!where->span.has(address))
                if (++where == others.data() + others.size()) return false;
        }
        if (!is_quiet(*where, address - where->span.begin, bytes)) return false;
        last_reads->add(address, pc);
        return true;
    }
};

extern constinit thread_local QuietReads quiet_reads;

} // namespace raylab::simt::watch
