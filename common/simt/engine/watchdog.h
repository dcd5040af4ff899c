// The watchdog: a launch that does not end is reported, with the statement that it is at.
#pragma once

namespace raylab::simt {

class Block;

// Which blocks there are to ask. Each from its making to its end.
void enrol(Block& block);
void strike_off(Block& block);

// While one lives, a launch is running. After the seconds that the environment names in
// RAYLAB_TIME_LIMIT the program is ended, with a report; without a limit nothing happens.
class TimedLaunch {
  public:
    TimedLaunch();
    ~TimedLaunch();
    TimedLaunch(const TimedLaunch&) = delete;
    TimedLaunch& operator=(const TimedLaunch&) = delete;
};

} // namespace raylab::simt
