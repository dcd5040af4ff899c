// Ctrl-C (SIGINT), SIGTERM and SIGHUP: the program keeps what it has computed so far, where a part
// of the result is of use.
#pragma once

#include <functional>

namespace raylab {

// For the first line of main(). From then on
//  - SIGINT, SIGTERM and SIGHUP end the program at once, with the exit status 128 + signal and
//    without leftovers (leftovers.h). Those that are ignored already stay ignored, as nohup
//    needs.
//  - SIGXFSZ (`ulimit -f`) is ignored, so that the write fails and the program reports it.
void catch_signals();

// While an object of this class lives, there is something to keep: the first signal only sets
// interrupted(), and a second one ends the program at once. A signal within .3 s after the first
// counts as the first: timeout(1) sends its signal to the process and to its group.
class KeepsWork {
  public:
    KeepsWork();
    ~KeepsWork();
    KeepsWork(const KeepsWork&) = delete;
    KeepsWork& operator=(const KeepsWork&) = delete;
};

// The signal that came while there was something to keep; 0: none.
int interrupted();

// Runs work() on a thread of its own and waits for its end, calling tick() now and then. Once
// interrupted(), it waits for at most `grace_seconds` more. Returns true if work() has ended; if
// work() threw, throws the same. Returns false if work() is still running, perhaps for minutes,
// since a thread cannot be stopped. Then keep what work() has set aside under a lock, and end the
// program. Do not return to the owner of the objects that work() uses.
bool run_interruptibly(const std::function<void()>& work, const std::function<void()>& tick = {},
                       double grace_seconds = 1);

} // namespace raylab
