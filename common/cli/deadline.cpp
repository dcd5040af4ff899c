#include "common/cli/deadline.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace raylab {

namespace {

// Of all its threads, without its own children; 0 if the system does not tell.
double processor_seconds([[maybe_unused]] pid_t child) {
#if defined(__linux__)
    clockid_t clock;
    timespec time;
    if (clock_getcpuclockid(child, &clock) == 0 && clock_gettime(clock, &time) == 0)
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
#endif
    return 0;
}

} // namespace

double now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

Deadline::Deadline(pid_t child, double limit_seconds, double last_seconds)
    : child_(child), limit_(limit_seconds), end_(now() + limit_seconds),
      last_(now() + last_seconds) {}

double Deadline::left() {
    const double time = now();
    if (time < end_ || end_ >= last_) return end_ - time;
    const double used = processor_seconds(child_);
    if (used >= limit_ || used <= used_) return end_ - time;
    used_ = used;
    end_ = std::min(last_, time + std::clamp(limit_ - used, 1.0, 5.0));
    return end_ - time;
}

} // namespace raylab
