// What each stage of a wavefront takes: launches, blocks, threads, and time on the device.
//
// Events in the stream measure the time, so that the host need not wait for each launch. The
// difference between their sum and the wall clock is the time for launching, copying and waiting.
#pragma once

#include "common/device/launch.h"
#include "common/film/ledger.h"

#include <span>

namespace raylab {

class StageClock {
  public:
    // names: of all stages, in the order of the lab's `enum class Stage`.
    explicit StageClock(std::span<const char* const> names);
    ~StageClock();
    StageClock(const StageClock&) = delete;
    StageClock& operator=(const StageClock&) = delete;

    // Runs work(), which launches kernels with `threads` threads in `blocks` blocks altogether.
    template <class Stage, class Work>
    void time(Stage stage, std::uint64_t blocks, std::uint64_t threads, const Work& work) {
        const auto number = static_cast<std::size_t>(stage);
        begin(number);
        work();
        end(number, blocks, threads);
    }

    // So far, in the order of the names. Waits for the device.
    const std::vector<StageCounts>& counts();

  private:
    struct Span {
        std::size_t stage;
        cudaEvent_t begin, end;
    };
    void begin(std::size_t stage);
    void end(std::size_t stage, std::uint64_t blocks, std::uint64_t threads);
    void read(); // adds up the spans that have been used

    std::vector<StageCounts> counts_;
    std::vector<Span> spans_;
    std::size_t used_ = 0;
};

} // namespace raylab
