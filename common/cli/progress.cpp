#include "common/cli/progress.h"

#include "common/cli/interrupt.h"
#include "common/math/index.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sys/ioctl.h>
#include <unistd.h>

namespace raylab {

namespace {

int terminal_columns() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

} // namespace

Progress::Progress(std::string label, int steps, std::string unit, double scale,
                   double seconds_between_lines)
    : label_(std::move(label)), unit_(std::move(unit)), steps_(steps), scale_(scale),
      seconds_between_lines_(seconds_between_lines), on_terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { clear(); }

void Progress::clear() {
    const std::lock_guard lock(mutex_);
    if (drawn_) fmt::print(stderr, "\r\033[K");
    drawn_ = false;
}

double Progress::seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::update(int done) { update(done, steps_); }

void Progress::update(int done, int steps) {
    const std::lock_guard lock(mutex_);
    steps_ = steps;
    done_ = done;
    show();
}

void Progress::tick() {
    const std::lock_guard lock(mutex_);
    show();
}

// The rate and the time left, if they are known.
std::string Progress::facts() const {
    if (done_ == 0) return human_duration(seconds()) + " so far";
    std::string rate = human_count(done_ * scale_ / seconds());
    if (rate.back() != ' ') rate += ' ';
    return fmt::format("{}{}/s, {} left", rate, unit_,
                       human_duration(seconds() / done_ * std::max(0, steps_ - done_)));
}

// As much as there is room for: first the facts go, then the bar.
std::string Progress::line(double percent, int columns) const {
    constexpr int width = 24;
    const int filled = index_of(width * percent / 100, width + 1);
    const std::string bar = fmt::format("[{:#<{}}{:.<{}}] ", "", filled, "", width - filled);
    const std::string share = fmt::format("{:3.0f} %", percent);
    const std::size_t room = static_cast<std::size_t>(std::max(1, columns - 1));
    for (const std::string& text : {label_ + " " + bar + share + "  " + facts(),
                                    label_ + " " + bar + share, label_ + " " + share})
        if (text.size() <= room) return text;
    return share.size() <= room ? share : "";
}

void Progress::show() {
    if (interrupted()) return; // the code that keeps the finished work prints now
    const Clock::time_point now = Clock::now();
    const double since = std::chrono::duration<double>(now - shown_).count();
    const double percent = steps_ > 0 ? std::min(100.0, 100.0 * done_ / steps_) : 100.0;
    if (!on_terminal_) {
        if (since < seconds_between_lines_ || done_ >= steps_) return;
        shown_ = now;
        fmt::print(stderr, "{}: {:.0f} %, {}\n", label_, std::floor(percent), facts());
        std::fflush(stderr);
        return;
    }
    // The first second is silent: what is quick needs no progress line.
    if (seconds() < 1 || (since < 0.1 && done_ < steps_)) return;
    shown_ = now;
    drawn_ = true;
    fmt::print(stderr, "\r\033[K{}", line(percent, terminal_columns()));
    std::fflush(stderr);
}

std::string human_duration(double seconds) {
    if (seconds < 10) return fmt::format("{:.1f} s", seconds);
    if (seconds < 90) return fmt::format("{:.0f} s", seconds);
    const int whole = index_of(std::round(seconds), std::numeric_limits<int>::max());
    if (whole >= 3600) return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
    return fmt::format("{} min {} s", whole / 60, whole % 60);
}

std::string human_count(double count) {
    if (count >= 1e9) return fmt::format("{:.2f} G", count / 1e9);
    if (count >= 1e6) return fmt::format("{:.2f} M", count / 1e6);
    if (count >= 1e3) return fmt::format("{:.2f} k", count / 1e3);
    return fmt::format("{:.0f} ", count);
}

} // namespace raylab
