// Progress of anything that takes over a second: share done, rate, time left.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace raylab {

// On a terminal, one line on standard error, which is drawn again and again, never wider than the
// terminal is at that moment, and removed by the destructor. Elsewhere, a new line about every ten
// seconds, so that a log shows that the work goes on; short work prints nothing into a pipe. Any
// thread may call.
class Progress {
  public:
    // unit: what is counted, in the plural ("samples"); scale: how many of them one step is worth.
    Progress(std::string label, int steps, std::string unit, double scale,
             double seconds_between_lines = 10);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(int done);            // steps so far
    void update(int done, int steps); // and how many there are, if that has changed
    void tick();                      // shows how time goes by while a step takes long
    void clear();                     // takes the line away, so that something else can be printed

    double seconds() const; // since construction

  private:
    using Clock = std::chrono::steady_clock;
    void show();
    std::string facts() const;
    std::string line(double percent, int columns) const;

    std::string label_, unit_;
    int steps_, done_ = 0;
    double scale_, seconds_between_lines_;
    bool on_terminal_, drawn_ = false;
    Clock::time_point start_ = Clock::now(), shown_ = start_;
    std::mutex mutex_;
};

// "0.8 s", "12 s", "3 min 20 s", "2 h 5 min": for people.
std::string human_duration(double seconds);

// "3.42 M": a count with a metric prefix.
std::string human_count(double count);

} // namespace raylab
