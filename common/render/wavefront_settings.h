// How lab 03 runs its pool of rays. No field changes a bit of the image.
#pragma once

#include <cstdint>

namespace raylab {

// The prefix sums that compaction and sorting are made of.
enum class ScanKind : int { serial, naive, efficient, warp, library, lookback };

// What is done so that neighbouring threads shade the same kind of material: nothing; the list of
// rays is sorted by kind; or each kind has a queue and a kernel of its own.
enum class MaterialSort : int { off, on, queues };

struct WavefrontSettings {
    int compact_every = 1; // bounces from one compaction to the next; 0: never
    ScanKind scan = ScanKind::library;
    MaterialSort sort = MaterialSort::off;
    int pool = 1 << 20;              // paths in flight, at most
    std::uint32_t shuffle = 0;       // seed that deals pixels out to slots; 0: in order
    std::int64_t memory_budget = 0;  // bytes of device memory; 0: all that the device has
    bool shared_geometry = false;    // read shapes from shared memory
    bool first_bounce_cache = false; // keep what camera rays hit from one iteration to the next
    bool regenerate = false;         // ended paths make room for new ones at once

    friend bool operator==(const WavefrontSettings&, const WavefrontSettings&) = default;
};

} // namespace raylab
