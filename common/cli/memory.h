// How much memory there is for this program, whoever sets the limit.
#pragma once

#include <cstdint>
#include <string>

namespace raylab {

struct AvailableMemory {
    std::uint64_t bytes;
    std::string limit; // who sets it, for people: "the machine has no more free"
};

// The least of what the machine has free (MemAvailable), what the control groups of a container or
// a batch job leave, and what `ulimit -v` leaves. What cannot be read is no limit. `root` is where
// /proc and /sys are: for tests.
AvailableMemory available_memory(const std::string& root = "");

// If `ulimit -v` is set, makes all threads share one heap. Otherwise the GNU C library reserves 64
// MiB of addresses for each thread that allocates, and the limit counts them though nobody uses
// them. Call this before all else.
void spare_address_space();

// The most that this program had in memory at once so far.
std::uint64_t peak_memory();

// "5.67 GiB", "12.0 MiB": for people.
std::string human_bytes(double bytes);

} // namespace raylab
