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
    void add(uint32_t site, int thread, uintptr_t address, unsigned bytes, bool writes,
             Memory memory);

    // Puts the accesses of the block together to requests. To be called at its end.
    void end_block();

    const std::map<uint32_t, Traffic>& by_site() const { return traffic_; }
    void clear() { traffic_.clear(); }

  private:
    static constexpr int lanes = 32;
    using Addresses = std::array<std::vector<uintptr_t>, lanes>; // of each lane, in its order
    void put_together(Traffic& traffic, const Addresses& addresses);

    std::map<uint32_t, Traffic> traffic_;
    std::map<std::pair<uint32_t, int>, Addresses> open_; // by site and warp
};

// Adds a launch to what is known of its kernel; when the program ends, all is written to stderr,
// and to the file of findings.
void add_traffic(const std::string& kernel, const std::map<SourcePlace, Traffic>& lines);

// A table for people: a line of the source each, the most sectors and conflicts first.
std::string traffic_table(const std::string& kernel, const std::map<SourcePlace, Traffic>& lines);

} // namespace raylab::simt::watch
