// What each stage of the wavefront takes: launches, blocks, threads, and time on the device.
//
// Time is taken by events in the stream, so that the host need not wait for each launch. What is
// missing between their sum and the wall clock is launching, copying and waiting.
#pragma once

#include "common/device/launch.h"
#include "common/film/ledger.h"

#include <array>

namespace raylab::lab04 {

enum class Stage : int {
    generate,
    walk,
    intersect,
    shade,
    walk_shadow_rays,
    shadow,
    compact,
    accumulate
};
inline constexpr std::array stage_names = {"generate",         "walk",   "intersect", "shade",
                                           "walk shadow rays", "shadow", "compact",   "accumulate"};

class StageClock {
  public:
    StageClock();
    ~StageClock();
    StageClock(const StageClock&) = delete;
    StageClock& operator=(const StageClock&) = delete;

    // Runs work(), which launches kernels with `threads` threads in `blocks` blocks altogether.
    template <class Work>
    void time(Stage stage, std::uint64_t blocks, std::uint64_t threads, const Work& work) {
        begin(stage);
        work();
        end(stage, blocks, threads);
    }

    // So far, in the order of Stage. Waits for the device.
    const std::vector<StageCounts>& counts();

  private:
    struct Span {
        Stage stage;
        cudaEvent_t begin, end;
    };
    void begin(Stage stage);
    void end(Stage stage, std::uint64_t blocks, std::uint64_t threads);
    void read(); // adds up the spans that have been used

    std::vector<StageCounts> counts_;
    std::vector<Span> spans_;
    std::size_t used_ = 0;
};

} // namespace raylab::lab04
