// What the loads and stores of warps cost: lanes that take part, sectors of global memory,
// conflicts of the banks of shared memory; for each line of the source.
//
// The model. A GPU executes an access for all lanes of a warp at once, as one request. Here the
// lanes come one after the other, so the nth execution of an access by each lane counts as one
// request of the warp: right where the lanes that take part in a loop's rounds do so together, an
// estimate where they part and meet again. A request to global memory moves each sector of 32 bytes
// that it touches once. Shared memory has 32 banks of 4 bytes; a request is repeated (a wavefront)
// for each further word that it wants of the same bank, and lanes that want one word share it.
// Caches are not modelled. The names are those of Nsight Compute: sectors per request, average
// active threads per warp, bank conflicts.
#pragma once

#include "common/simt/finding.h"
#include "common/simt/watch/shadow.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace raylab::simt::watch {

struct Traffic {
    Memory memory = Memory::global;
    bool writes = false;
    unsigned bytes = 0; // of one access
    std::uint64_t requests = 0, lanes = 0, sectors = 0, wavefronts = 0;
    std::uint64_t least_sectors = 0; // if the same bytes lay side by side

    Traffic& operator+=(const Traffic& other);
    double sectors_per_request() const { return double(sectors) / double(requests); }
    double active_threads() const { return double(lanes) / double(requests); }
    std::uint64_t bank_conflicts() const { return wavefronts - requests; } // of shared memory
};

class TrafficCounter {
  public:
    // `site`: of RaceBook::site(), so numbers are dense.
    void add(uint32_t site, int thread, uintptr_t address, unsigned bytes, bool writes,
             Memory memory) {
        const unsigned shift = memory == Memory::shared ? bank_shift : sector_shift;
        const uintptr_t begin = address >> shift;
        const uint32_t units = uint32_t(((address + bytes - 1) >> shift) - begin + 1);
        const size_t place = size_t(site) * warps + size_t(thread / lanes);
        if (place >= open_.size()) open_.resize(place + warps);
        Open& warp = open_[place];
        const uint32_t number = warp.next[size_t(thread % lanes)]++;
        if (number == warp.requests.size()) {
            if (number == 0) touch(warp, site, {memory, writes, bytes});
            warp.requests.push_back({begin, units, 1, 0});
            return;
        }
        Request& request = warp.requests[number];
        ++request.lanes;
        if (begin < request.begin || begin + units > request.begin + request.units)
            want(request, begin, units);
    }

    // Counts the requests of the block. To be called at its end.
    void end_block();

    const std::vector<Traffic>& by_site() const { return traffic_; }
    void clear() { traffic_.clear(); }

  private:
    static constexpr int lanes = 32, warps = 32;
    static constexpr unsigned sector_shift = 5, bank_shift = 2; // of bytes, as powers of two
    // What the nth access of each lane wants, in sectors of global memory or words of shared
    // memory. Almost always these lie side by side; those that do not are kept in a list.
    struct Request {
        uintptr_t begin; // of those side by side
        uint32_t units : 24, lanes : 8;
        uint32_t others; // number of the list, from 1 on; 0: none
    };
    struct Open { // the requests of one warp from one site
        uint32_t site = 0;
        std::array<uint32_t, lanes> next{}; // by lane
        std::vector<Request> requests;
    };
    void touch(Open& open, uint32_t site, const Traffic& kind);
    void want(Request& request, uintptr_t begin, uint32_t units);
    void count(Traffic& traffic, const Request& request);

    std::vector<Traffic> traffic_; // by site
    std::vector<Open> open_;       // by site and warp
    std::vector<size_t> touched_;  // of these, in this block
    std::vector<std::vector<uintptr_t>> others_;
    size_t used_others_ = 0;
    std::vector<uintptr_t> scratch_;
};

// Adds a launch to what is known of its kernel; when the program ends, all is written to stderr,
// and to the file of findings.
void add_traffic(const std::string& kernel, const std::map<SourcePlace, Traffic>& lines);

// A table for people: a line of the source each, the most sectors and conflicts first.
std::string traffic_table(const std::string& kernel, const std::map<SourcePlace, Traffic>& lines);

} // namespace raylab::simt::watch
