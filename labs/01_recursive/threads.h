// Threads with room for deep recursion.
#pragma once

#include <cstddef>
#include <functional>

namespace raylab::lab01 {

// Runs work() on `count` threads at once, each with a stack of at least `stack_bytes`, and waits
// until all have ended. The operating system provides a stack's memory only where it is used.
// Throws std::system_error if a thread cannot be started.
void run_on_threads(int count, std::size_t stack_bytes, const std::function<void()>& work);

} // namespace raylab::lab01
