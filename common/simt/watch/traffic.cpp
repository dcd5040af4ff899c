#include "common/simt/watch/traffic.h"

#include <algorithm>

namespace raylab::simt::watch {

namespace {

constexpr uintptr_t sector_bytes = 32, banks = 32;

size_t count_distinct(std::vector<uintptr_t>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values.size();
}

// Of the words that a request wants: the most of one bank, each word once.
size_t most_of_a_bank(std::vector<uintptr_t>& words) {
    count_distinct(words);
    std::array<size_t, banks> wanted{};
    for (const uintptr_t word : words) ++wanted[word % banks];
    return *std::max_element(wanted.begin(), wanted.end());
}

} // namespace

Traffic& Traffic::operator+=(const Traffic& other) {
    memory = other.memory;
    writes = other.writes;
    bytes = other.bytes;
    requests += other.requests;
    lanes += other.lanes;
    sectors += other.sectors;
    wavefronts += other.wavefronts;
    least_sectors += other.least_sectors;
    return *this;
}

void TrafficCounter::touch(Open& open, uint32_t site, const Traffic& kind) {
    touched_.push_back(size_t(&open - open_.data()));
    open.site = site;
    if (site >= traffic_.size()) traffic_.resize(site + 1);
    traffic_[site] += kind;
}

void TrafficCounter::want(Request& request, uintptr_t begin, uint32_t units) {
    const uintptr_t end = begin + units, wanted_end = request.begin + request.units;
    if (begin <= wanted_end && request.begin <= end) {
        request.begin = std::min(request.begin, begin);
        request.units = uint32_t(std::max(wanted_end, end) - request.begin) & 0xffffff;
        return;
    }
    if (!request.others) {
        request.others = uint32_t(++used_others_);
        if (used_others_ > others_.size()) others_.emplace_back().reserve(lanes);
    }
    for (; begin < end; ++begin) others_[request.others - 1].push_back(begin);
}

void TrafficCounter::end_block() {
    for (const size_t place : touched_) {
        Open& open = open_[place];
        for (const Request& request : open.requests) count(traffic_[open.site], request);
        open.requests.clear();
        open.next.fill(0);
    }
    touched_.clear();
    for (size_t i = 0; i < used_others_; ++i) others_[i].clear();
    used_others_ = 0;
}

void TrafficCounter::count(Traffic& traffic, const Request& request) {
    ++traffic.requests;
    traffic.lanes += request.lanes;
    const bool is_shared = traffic.memory == Memory::shared;
    std::uint64_t wanted = request.units;
    if (request.others) {
        scratch_ = others_[request.others - 1];
        for (unsigned i = 0; i < request.units; ++i) scratch_.push_back(request.begin + i);
        wanted = is_shared ? most_of_a_bank(scratch_) : count_distinct(scratch_);
    } else if (is_shared) {
        wanted = (wanted + banks - 1) / banks;
    }
    if (is_shared) {
        traffic.wavefronts += wanted;
        return;
    }
    traffic.sectors += wanted;
    traffic.least_sectors += std::min<std::uint64_t>(
        wanted, (request.lanes * traffic.bytes + sector_bytes - 1) / sector_bytes);
}

} // namespace raylab::simt::watch
