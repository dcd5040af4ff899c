#include "common/simt/watch/race_book.h"

#include <algorithm>
#include <cstring>

namespace raylab::simt::watch {

namespace {

uint64_t load(uintptr_t address, unsigned bytes) {
    uint64_t value = 0;
    std::memcpy(&value, reinterpret_cast<const void*>(address), bytes < 8 ? bytes : 8);
    return value;
}

} // namespace

uint32_t RaceBook::site(Pc pc) {
    Recent& recent = recent_[uintptr_t(pc) % recent_.size()];
    if (recent.pc == pc) return recent.site;
    const auto found = sites_.find(pc);
    const uint32_t site = found != sites_.end() ? found->second : uint32_t(pcs_.size() + 1);
    if (found == sites_.end()) {
        sites_.emplace(pc, site);
        pcs_.push_back(pc);
    }
    recent = {pc, site};
    return site;
}

void RaceBook::stored(Race& race, uint64_t value) {
    race.one_value = race.one_value && (!race.has_value || race.value == value);
    race.has_value = true;
    race.value = value;
}

void RaceBook::note(const Race& race, uintptr_t address, unsigned bytes) {
    // By value: minmax() gives references, and sites are fields of bits.
    const std::pair<uint32_t, uint32_t> key = std::minmax(race.before.site, race.after.site);
    const auto [found, is_new] = races_.emplace(key, race);
    Race& known = found->second;
    if (is_new) order_.push_back(key);
    ++known.count;
    if (race.before_wrote) {
        stored(known, load(address, bytes));
        known.after_reads = known.after_reads && race.before.has_read;
    }
    if (race.after_wrote) {
        known.after_reads = known.after_reads && race.after.has_read;
        pending_ = &known;
        pending_address_ = address;
        pending_bytes_ = bytes;
    }
}

void RaceBook::settle_pending() {
    stored(*pending_, load(pending_address_, pending_bytes_));
    pending_ = nullptr;
}

const char* RaceBook::why_harmless(const Race& race) const {
    const bool one_is_atomic = is_atomic(race.before.touch) || is_atomic(race.after.touch);
    const bool one_reads = !(race.before_wrote && race.after_wrote);
    const Access& reader = race.before_wrote ? race.after : race.before;
    if (one_is_atomic && one_reads && !is_atomic(reader.touch) && checked_.contains(reader.site))
        return "the value read is checked again by an atomic operation";
    if (race.memory == Memory::shared && one_reads) return nullptr;
    if (race.before.touch == Touch::volatile_ && race.after.touch == Touch::volatile_ &&
        race.memory != Memory::shared)
        return "both accesses are volatile";
    const uint32_t storing = race.before_wrote ? race.before.site : race.after.site;
    const auto others = races_.find({storing, storing});
    const bool is_flag =
        !one_reads || race.after_reads ||
        (others != races_.end() && others->second.before_wrote && others->second.after_wrote);
    if (race.one_value && race.value != 0 && !one_is_atomic && is_flag) // 0 may be all data
        return "every store from there stores the same value";
    return nullptr;
}

bool RaceBook::has_error_at(uint32_t site) const {
    return std::any_of(races_.begin(), races_.end(), [&](const auto& entry) {
        const auto& [key, race] = entry;
        return (key.first == site || key.second == site) && !why_harmless(race);
    });
}

void RaceBook::clear() {
    races_.clear();
    order_.clear();
    pending_ = nullptr;
}

} // namespace raylab::simt::watch
