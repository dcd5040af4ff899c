// A finding: one mistake that the CPU machine has seen in a CUDA program, and where.
//
// The engine writes each as one line of JSON to the file that the environment names in
// RAYLAB_FINDINGS (engine/findings.h); `raylab run` reads them and prints them for people, editors
// and CI.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace raylab::simt {

// A statement. Line and column count from 1; 0: not known.
struct SourcePlace {
    std::string file;
    int line = 0, column = 0;
    auto operator<=>(const SourcePlace&) const = default;
};

enum class Severity { note, warning, error };

using Index3 = std::array<unsigned, 3>; // x, y, z

// Who did it. Nothing of it is known for host code.
struct Actor {
    std::string kernel; // as written at the launch
    std::optional<Index3> block, thread;
};

struct Finding {
    std::string kind; // one word or more with hyphens, for filters: "race", "null-pointer"
    Severity severity = Severity::error;
    SourcePlace place;
    std::string message; // one sentence: what is wrong
    std::string advice;  // one sentence: how to mend it
    Actor actor;

    // The other end, of a race for instance.
    struct Other {
        SourcePlace place;
        std::string what; // "read", "write": what happened there
        Actor actor;
    };
    std::optional<Other> other;

    std::int64_t count = 1; // how often it was seen there
    std::string mode;       // of the machine: plain, bounds, races, order
};

// What a run did, for the sentence "this was checked".
struct RunSummary {
    std::uint64_t launches = 0, threads = 0; // of kernels
    std::uint64_t allocations = 0, bytes = 0;
};

// What one access of a kernel cost, over all launches: `raylab run --machine memory`. The model is
// that of watch/traffic.h, the names are Nsight Compute's.
struct AccessCost {
    std::string kernel, memory, access; // "global" or "shared"; "read" or "write"
    SourcePlace place;
    unsigned bytes = 0; // of one thread's access
    std::uint64_t requests = 0;
    double threads_per_warp = 0;
    double sectors_per_request = 0, least_sectors_per_request = 0; // of global memory
    std::uint64_t bank_conflicts = 0;                              // of shared memory
};

const char* name(Severity severity);

// One object on one line, without its line break; what is not known is left out.
std::string to_json_line(const Finding& finding);
std::string to_json_line(const RunSummary& summary);
std::string to_json_line(const AccessCost& cost);

// What lines of JSON say. A summary repeats with larger numbers: the last one holds. Lines that are
// cut off or of another kind are passed over.
struct FindingsFile {
    std::vector<Finding> findings;
    std::optional<RunSummary> summary;
    std::vector<AccessCost> costs;
};
FindingsFile parse_findings(const std::string& lines);

// Findings of the same kind and severity at the same place, with the same other place, become the
// first of them with the sum of their counts. The order stays.
std::vector<Finding> folded(const std::vector<Finding>& findings);

} // namespace raylab::simt
