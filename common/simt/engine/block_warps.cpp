// What the lanes of a warp do together: they wait for each other, and each gets what it came for;
// see block.h.
#include "common/simt/engine/block.h"
#include "common/simt/engine/report.h"
#include "common/simt/watch/events.h"

#include <bit>
#include <cstring>

namespace raylab::simt {

// The lanes of a warp that the block has threads for; the last warp may be a part of one.
unsigned Block::existing(int warp) const {
    int left = count_ - warp * lanes;
    return left >= lanes ? ~0u : (1u << left) - 1;
}

uint64_t Block::warp_operation(Wait kind, const Site& site, unsigned mask, uint64_t value,
                               int source) {
    int warp = running_ / lanes, lane = running_ % lanes;
    Waiter& waiter = waiters_[running_];
    if (!(mask >> lane & 1)) {
        watch::pause();
        give_up(Report(*this).not_in_mask(site, mask));
    }

    unsigned members = mask & existing(warp);
    Meeting& meeting = warp_meetings_[warp * lanes + std::countr_zero(members)];
    void* point = meeting.now();
    announce_release(point);
    arrive(kind, site);
    waiter.mask = mask;
    waiter.value = value;
    waiter.source = source;
    in_operation_[warp] |= 1u << lane;
    if ((in_operation_[warp] & members) == members && agree(warp, members)) {
        complete(warp, members);
        meeting.turn ^= 1;
    }
    suspend();
    announce_acquire(point);
    return waiter.value;
}

// What every lane of the mask brings, for every one of them.
void Block::gather(const Site& site, unsigned mask, uint64_t value, uint64_t* all) {
    waiters_[running_].all = all;
    warp_operation(Wait::gather, site, mask, value, 0);
}

// Whether these lanes, all waiting, wait for each other.
bool Block::agree(int warp, unsigned members) const {
    const Waiter& first = waiters_[warp * lanes + std::countr_zero(members)];
    for (unsigned rest = members; rest; rest &= rest - 1)
        if (!meet(first, waiters_[warp * lanes + std::countr_zero(rest)])) return false;
    return true;
}

// Hands every lane what it gets, and makes it ready.
void Block::complete(int warp, unsigned members) {
    Waiter* warp_waiters = &waiters_[warp * lanes];
    const int first = warp * lanes + std::countr_zero(members);
    uint64_t brought[lanes] = {}, ballot = 0;
    uint16_t threads[lanes];
    int count = 0;
    for (int turn = 0; turn < lanes; ++turn) {
        int lane = options_.order == Order::reverse ? lanes - 1 - turn : turn;
        if (!(members >> lane & 1)) continue;
        threads[count++] = uint16_t(warp * lanes + lane);
        brought[lane] = warp_waiters[lane].value;
        ballot |= uint64_t(brought[lane] != 0) << lane;
    }
    for (int i = 0; i < count; ++i) {
        Waiter& waiter = waiters_[threads[i]];
        if (waiter.kind == Wait::vote) waiter.value = ballot;
        if (waiter.kind == Wait::gather) std::memcpy(waiter.all, brought, sizeof brought);
        if (waiter.kind != Wait::shuffle) continue;
        const bool is_there = members >> waiter.source & 1;
        if (!is_there && threads[i] == first) warn_once(threads[i]);
        waiter.value = is_there ? brought[waiter.source] : ~uint64_t(0);
    }
    in_operation_[warp] &= ~members;
    watch::meet(warp, members);
    make_ready(threads, count);
}

// No one can go on, except those who only want to know who is with them: in each warp the lanes at
// the place of the first one are together.
bool Block::release_converged() {
    bool released = false;
    for (int warp = 0; warp * lanes < count_; ++warp) {
        unsigned waiting = converging_[warp], together = 0;
        if (!waiting) continue;
        const Site* site = waiters_[warp * lanes + std::countr_zero(waiting)].site;
        uint16_t threads[lanes];
        int count = 0;
        for (unsigned rest = waiting; rest; rest &= rest - 1) {
            int thread = warp * lanes + std::countr_zero(rest);
            if (waiters_[thread].site != site) continue;
            threads[count++] = uint16_t(thread);
            together |= rest & -rest;
        }
        for (int i = 0; i < count; ++i) waiters_[threads[i]].value = together;
        converging_[warp] &= ~together;
        make_ready(threads, count);
        released = true;
    }
    return released;
}

unsigned Block::active_mask(const Site& site) {
    Waiter& waiter = waiters_[running_];
    arrive(Wait::converge, site);
    converging_[running_ / lanes] |= 1u << running_ % lanes;
    suspend();
    return unsigned(waiter.value);
}

} // namespace raylab::simt
