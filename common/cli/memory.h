// How much memory this program can get, under all the limits that apply.
#pragma once

#include <cstdint>
#include <string>

namespace raylab {

struct AvailableMemory {
    std::uint64_t bytes;
    std::string limit; // which limit it is, for people: "the machine has no more free"
};

// The least of three: the free memory of the machine (MemAvailable), what the control groups of a
// container or a batch job leave, and what `ulimit -v` leaves. A limit that cannot be read does not
// count. `root` is the folder of /proc and /sys, for tests.
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
