// A progress line for anything that takes over a second: share done, rate, time left.
#pragma once

#include <chrono>
#include <string>

namespace raylab {

// Draws on standard error when that is a terminal, and nothing at all when it is not, so logs and
// pipes stay clean. The line is erased when the object dies.
class Progress {
  public:
    // unit: what is counted, in the plural ("samples"); scale: how many of them one step is worth.
    Progress(std::string label, int steps, std::string unit, double scale);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(int done); // draws at most ten times a second
    void clear();          // takes the line away, so that something else can be printed

    double seconds() const; // since construction

  private:
    using Clock = std::chrono::steady_clock;

    std::string label_, unit_;
    int steps_;
    double scale_;
    bool visible_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point drawn_;
};

// "0.8 s", "12 s", "3 min 20 s": for people.
std::string human_duration(double seconds);

// "3.42 M": a count with a metric prefix.
std::string human_count(double count);

} // namespace raylab
