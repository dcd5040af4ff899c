// How much of a submission is read. A right submission of any lab stays below a hundredth of each.
#pragma once

#include <cstdint>

namespace raylab {

struct UnpackLimits {
    std::uint64_t entries = 20000;    // files and folders
    std::uint64_t bytes = 512u << 20; // of all files of an archive, unpacked
    std::uint64_t taken = 64u << 20;  // of the files that are taken out of an archive
    std::uint64_t source = 1u << 20;  // of one source file
    std::uint64_t ratio = 200;        // unpacked bytes over the archive's, above 32 MiB
    int depth = 32;                   // folders in one another
    std::uint64_t name = 1024;        // bytes of a name with its folders
};

// A class: many submissions in one archive. One student's junk must not refuse all others', so
// there is no ratio: what is skipped costs nothing, and what is taken has a limit.
inline UnpackLimits class_limits() {
    UnpackLimits limits;
    limits.entries = 2000000;
    limits.bytes = std::uint64_t(64) << 30;
    limits.taken = std::uint64_t(8) << 30;
    limits.ratio = ~std::uint64_t(0);
    return limits;
}

} // namespace raylab
