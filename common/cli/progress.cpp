#include "common/cli/progress.h"

#include "common/math/index.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <unistd.h>

namespace raylab {

Progress::Progress(std::string label, int steps, std::string unit, double scale)
    : label_(std::move(label)), unit_(std::move(unit)), steps_(steps), scale_(scale),
      visible_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { clear(); }

void Progress::clear() {
    if (visible_ && drawn_ != Clock::time_point{}) fmt::print(stderr, "\r\033[K");
}

double Progress::seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::update(int done) {
    // The first second is silent: what is quick needs no progress line.
    if (!visible_ || seconds() < 1 || done <= 0) return;
    const Clock::time_point now = Clock::now();
    if (done < steps_ && now - drawn_ < std::chrono::milliseconds(100)) return;
    drawn_ = now;

    constexpr int width = 24;
    const int filled = static_cast<int>(static_cast<double>(width) * done / steps_);
    const double rate = done * scale_ / seconds();
    const double left = seconds() / done * (steps_ - done);
    fmt::print(stderr, "\r\033[K{} [{:#<{}}{:.<{}}] {:3.0f} %  {} {}/s  {} left", label_, "",
               filled, "", width - filled, 100.0 * done / steps_, human_count(rate), unit_,
               human_duration(left));
    std::fflush(stderr);
}

std::string human_duration(double seconds) {
    if (seconds < 10) return fmt::format("{:.1f} s", seconds);
    if (seconds < 90) return fmt::format("{:.0f} s", seconds);
    const int whole = index_of(std::round(seconds), std::numeric_limits<int>::max());
    return fmt::format("{} min {} s", whole / 60, whole % 60);
}

std::string human_count(double count) {
    if (count >= 1e9) return fmt::format("{:.2f} G", count / 1e9);
    if (count >= 1e6) return fmt::format("{:.2f} M", count / 1e6);
    if (count >= 1e3) return fmt::format("{:.2f} k", count / 1e3);
    return fmt::format("{:.0f} ", count);
}

} // namespace raylab
