// The races of a launch, folded to one for each pair of places in the source, and judged at its
// end.
//
// What an access of a race stored is known only after it. A race in which every store of the launch
// from that place stores one value to a flag does no harm on a GPU and is a note. A flag is what
// several threads store to, or what they read before. (Where each thread stores to a place of its
// own, one value may be what all data of a test are.) So is a plain read that an atomicCAS(),
// atomicMin() or atomicMax() of the same thread checks again (CUDA C++ Programming Guide, "Atomic
// Functions").
#pragma once

#include "common/simt/watch/shadow.h"

#include <array>
#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace raylab::simt::watch {

struct Race {
    Access before, after;
    bool before_wrote = false, after_wrote = false;
    Memory memory = Memory::global;
    uint64_t count = 0;
    bool one_value = true;   // so far
    bool after_reads = true; // all stores so far have Access::has_read
    bool has_value = false;
    uint64_t value = 0;
};

class RaceBook {
  public:
    // Numbers places in the code: equal for equal ones, from 1 on.
    uint32_t site(Pc pc);
    Pc pc(uint32_t site) const { return pcs_[site - 1]; }

    // `bytes` bytes at `address` hold what the one who wrote before stored; what `after` stores is
    // there when settle() is next called.
    void note(const Race& race, uintptr_t address, unsigned bytes);
    void settle() {
        if (pending_) settle_pending();
    }
    void checked_again(uint32_t reading_site) { checked_.insert(reading_site); }

    // Why a race is harmless, or null.
    const char* why_harmless(const Race& race) const;

    bool has_error_at(uint32_t site) const;

    const std::map<std::pair<uint32_t, uint32_t>, Race>& races() const { return races_; }
    const std::vector<std::pair<uint32_t, uint32_t>>& in_order() const { return order_; }
    void clear();

  private:
    void settle_pending();
    static void stored(Race& race, uint64_t value);

    struct Recent {
        Pc pc;
        uint32_t site;
    };
    std::array<Recent, 4096> recent_{}; // of the sites, by address: most questions are about few
    std::unordered_map<Pc, uint32_t> sites_;
    std::vector<Pc> pcs_;
    std::map<std::pair<uint32_t, uint32_t>, Race> races_;
    std::vector<std::pair<uint32_t, uint32_t>> order_;
    std::unordered_set<uint32_t> checked_; // in any launch

    Race* pending_ = nullptr;
    uintptr_t pending_address_ = 0;
    unsigned pending_bytes_ = 0;
};

} // namespace raylab::simt::watch
