// Where `raylab debug` stops: at one bounce of one path.
//
// Every decision of a path takes random numbers, so the Sampler knows which path is at which
// bounce, in every lab. It tells path_is_at(). In the build for gdb (RAYLAB_STOPS) that function
// compares three numbers; in every other build it is empty.
#pragma once

#include "common/math/hd.h"

#include <cstdint>

#if defined(RAYLAB_STOPS)
#include <cstdio>
#include <cstdlib>
#endif

namespace raylab {

constexpr int camera_ray_stop = -1; // in place of a bounce: where the path begins

#if defined(RAYLAB_STOPS)

// gdb's breakpoint.
[[gnu::noinline]] inline void path_stop() { asm volatile(""); }

// What the environment's RAYLAB_STOP asks for, "pixel sample bounce", and how far that path came.
class PathStop {
  public:
    PathStop() {
        const char* text = std::getenv("RAYLAB_STOP");
        asked_ = text && std::sscanf(text, "%u %u %d", &pixel_, &sample_, &bounce_) == 3;
    }
    ~PathStop() {
        if (!asked_) return;
        if (last_ < camera_ray_stop)
            std::fprintf(stderr, "no path began in pixel %u, sample %u\n", pixel_, sample_);
        else
            std::fprintf(
                stderr,
                "the path of pixel %u, sample %u did not come to bounce %d; the last bounce in "
                "which it took random numbers is %d (%d: its camera ray)\n",
                pixel_, sample_, bounce_, last_, camera_ray_stop);
    }
    // Whether this is the place; true once.
    bool reached(std::uint32_t pixel, std::uint32_t sample, int bounce) {
        if (!asked_ || pixel != pixel_ || sample != sample_) return false;
        last_ = bounce;
        if (bounce == bounce_) asked_ = false;
        return !asked_;
    }

  private:
    std::uint32_t pixel_ = 0, sample_ = 0;
    int bounce_ = 0, last_ = camera_ray_stop - 1;
    bool asked_ = false;
};

inline void path_is_at(std::uint32_t pixel, std::uint32_t sample, int bounce) {
    static PathStop stop;
    if (stop.reached(pixel, sample, bounce)) path_stop();
}

#else

HD constexpr void path_is_at(std::uint32_t, std::uint32_t, int) {}

#endif

} // namespace raylab
