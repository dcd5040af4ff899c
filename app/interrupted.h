// How a command ends after a signal, if it keeps its finished work (common/cli/interrupt.h).
#pragma once

#include <functional>
#include <string>

namespace raylab::app {

// Calls keep() and ends the program with 128 + signal, even if threads still run. If keep() throws,
// prints a sentence and ends the program with 2 or 3.
[[noreturn]] void end_interrupted(const std::function<void()>& keep);

// On standard error, "raylab: interrupted by SIGTERM" and the rest of that sentence: what was kept.
void say_interrupted(const std::string& rest);

} // namespace raylab::app
