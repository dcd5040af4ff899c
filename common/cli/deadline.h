// Until when a program may run: so many seconds, and longer where the machine was busy with other
// work.
#pragma once

#include <sys/types.h>

namespace raylab {

double now(); // seconds, of a clock that never stops

// The time is up when the limit is over and the program has had as much processor time. Until then,
// but at most until `last_seconds`, a program goes on whose processor time grows: it is kept
// waiting. One whose time does not grow waits for itself.
class Deadline {
  public:
    // Both from now on. last_seconds: not more than limit_seconds: the limit alone counts.
    Deadline(pid_t child, double limit_seconds, double last_seconds);

    // Seconds until the time is up, or until it must be asked again; 0 or less when it is up.
    double left();

  private:
    pid_t child_;
    double limit_, end_, last_, used_ = 0;
};

} // namespace raylab
