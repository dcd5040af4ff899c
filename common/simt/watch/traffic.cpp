#include "common/simt/watch/traffic.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace raylab::simt::watch {

namespace {

constexpr uintptr_t sector_bytes = 32, bank_bytes = 4, banks = 32;

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

void TrafficCounter::add(uint32_t site, int thread, uintptr_t address, unsigned bytes, bool writes,
                         Memory memory) {
    Traffic& traffic = traffic_[site];
    traffic.memory = memory;
    traffic.writes = writes;
    traffic.bytes = bytes;
    open_[{site, thread / lanes}][size_t(thread % lanes)].push_back(address);
}

void TrafficCounter::end_block() {
    for (const auto& [key, addresses] : open_) put_together(traffic_[key.first], addresses);
    open_.clear();
}

void TrafficCounter::put_together(Traffic& traffic, const Addresses& addresses) {
    size_t rounds = 0;
    for (const auto& lane : addresses) rounds = std::max(rounds, lane.size());
    std::vector<uintptr_t> sectors, words;
    for (size_t round = 0; round < rounds; ++round) {
        sectors.clear();
        words.clear();
        std::uint64_t active = 0;
        for (const auto& lane : addresses) {
            if (round >= lane.size()) continue;
            ++active;
            const uintptr_t first = lane[round], last = first + traffic.bytes - 1;
            for (uintptr_t s = first / sector_bytes; s <= last / sector_bytes; ++s)
                sectors.push_back(s);
            for (uintptr_t w = first / bank_bytes; w <= last / bank_bytes; ++w) words.push_back(w);
        }
        ++traffic.requests;
        traffic.lanes += active;
        if (traffic.memory == Memory::shared) {
            traffic.wavefronts += most_of_a_bank(words);
            continue;
        }
        const std::uint64_t moved = count_distinct(sectors),
                            side_by_side =
                                (active * traffic.bytes + sector_bytes - 1) / sector_bytes;
        traffic.sectors += moved;
        traffic.least_sectors += std::min(moved, side_by_side);
    }
}

std::string traffic_table(const std::string& kernel, const std::map<SourcePlace, Traffic>& lines) {
    std::vector<std::pair<SourcePlace, Traffic>> rows(lines.begin(), lines.end());
    const auto cost = [](const Traffic& t) { return t.sectors + t.wavefronts; };
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const auto& a, const auto& b) { return cost(a.second) > cost(b.second); });
    std::string text = "kernel " + kernel +
                       "\n  memory  access   requests  threads/warp  sectors/request (least)  bank "
                       "conflicts  line\n";
    for (const auto& [place, t] : rows) {
        char row[256];
        const bool is_shared = t.memory == Memory::shared;
        std::snprintf(row, sizeof row, "  %-7s %-6s %10llu  %12.1f  ",
                      is_shared ? "shared" : "global", t.writes ? "write" : "read",
                      static_cast<unsigned long long>(t.requests), t.active_threads());
        text += row;
        if (is_shared)
            std::snprintf(row, sizeof row, "%23s  %14llu", "",
                          static_cast<unsigned long long>(t.bank_conflicts()));
        else
            std::snprintf(row, sizeof row, "%14.1f (%6.1f)  %14s", t.sectors_per_request(),
                          double(t.least_sectors) / double(t.requests), "");
        text += row;
        text += "  " + place.file + ":" + std::to_string(place.line) + ":" +
                std::to_string(place.column) + "\n";
    }
    return text;
}

} // namespace raylab::simt::watch
