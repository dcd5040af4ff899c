// How a command that keeps its work ends when a signal came (common/cli/interrupt.h).
#pragma once

#include <functional>
#include <string>

namespace raylab::app {

// Keeps what there is and ends the program with 128 + signal, whatever is still running; with 2 or
// 3 and a sentence if keep() throws.
[[noreturn]] void end_interrupted(const std::function<void()>& keep);

// On standard error, "raylab: interrupted by SIGTERM" and the rest of that sentence: what was kept.
void say_interrupted(const std::string& rest);

} // namespace raylab::app
