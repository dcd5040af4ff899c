// Ctrl-C (SIGINT), SIGTERM and SIGHUP: what was worked out so far is kept, where that means
// something.
#pragma once

#include <functional>

namespace raylab {

// For the first line of main(). From then on
//  - SIGINT, SIGTERM and SIGHUP end the program at once, with the exit status 128 + signal and
//    without leftovers (leftovers.h). Those that are ignored stay so: nohup.
//  - SIGXFSZ (`ulimit -f`) is ignored, so that the write fails, which somebody notices.
void catch_signals();

// While one lives there is something to keep: the first signal only sets interrupted(), and a
// second one ends the program at once. What comes within .3 s counts as the first: timeout(1) sends
// its signal to the process and to its group.
class KeepsWork {
  public:
    KeepsWork();
    ~KeepsWork();
    KeepsWork(const KeepsWork&) = delete;
    KeepsWork& operator=(const KeepsWork&) = delete;
};

// The signal that came while there was something to keep; 0: none.
int interrupted();

// Runs work() on a thread of its own and waits for its end, calling tick() now and then; but once
// interrupted(), for at most `grace_seconds`. True: it has ended, and what it threw is thrown on.
// False: it is still at work, perhaps for minutes, and cannot be stopped: keep what it has set
// aside, under a lock, and end the program without returning to whoever owns what it uses.
bool run_interruptibly(const std::function<void()>& work, const std::function<void()>& tick = {},
                       double grace_seconds = 1);

} // namespace raylab
