// How the CPU machine runs kernels. A correct kernel gives the same result under all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace raylab::simt {

// In which order threads of a block, and blocks of a grid, get their turn. For forward, the usual
// order, another one is taken if the environment's RAYLAB_ORDER names it.
enum class Order { forward, reverse, random };

// Virtual memory, only what is used becomes real; but ThreadSanitizer touches four times as much.
#if defined(RAYLAB_CHECK_THREAD)
inline constexpr size_t default_stack_size = size_t(64) << 10;
#else
inline constexpr size_t default_stack_size = size_t(256) << 10;
#endif

struct Options {
    int threads = 0; // worker threads; 0: as many as the hardware runs at once
    Order order = Order::forward;
    uint64_t seed = 1;                      // of Order::random
    size_t stack_size = default_stack_size; // bytes for each CUDA thread that has to wait
    // Whether whole warps that have returned are missed at a barrier (CUDA before Volta; a habit to
    // avoid).
    bool strict_barriers = false;
    bool print_reports = true; // write reports to stderr the moment they are made
    bool operator==(const Options&) const = default;
};

// Holds from the next launch on. Throws std::invalid_argument, naming the field, for threads < 0 or
// a stack below 16 KiB. Not while a kernel runs.
void set_options(const Options& options);
Options options();

// Device memory in use that malloc() does not know of: it lies in pages of its own.
size_t mapped_bytes();

// The text of the latest fault or refused launch: what, where, what was expected, what to do. Empty
// if there was none since the start or the last cudaDeviceReset().
std::string last_report();

} // namespace raylab::simt
