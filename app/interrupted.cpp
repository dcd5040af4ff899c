#include "app/interrupted.h"

#include "app/errors.h"
#include "common/cli/interrupt.h"
#include "common/cli/leftovers.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstring>
#include <unistd.h>

namespace raylab::app {

void end_interrupted(const std::function<void()>& keep) {
    int status = 128 + interrupted();
    try {
        keep();
    } catch (...) {
        status = static_cast<int>(report_exception());
    }
    std::fflush(nullptr);
    end_without_leftovers(status); // threads that still run use objects, so none may be destroyed
    for (;;) pause(); // another thread is just starting a child; that thread ends the program
}

void say_interrupted(const std::string& rest) {
#if defined(__APPLE__)
    fmt::print(stderr, "raylab: interrupted by signal {}{}\n", interrupted(), rest);
#else
    fmt::print(stderr, "raylab: interrupted by SIG{}{}\n", sigabbrev_np(interrupted()), rest);
#endif
}

} // namespace raylab::app
