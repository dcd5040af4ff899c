// What an instruction of aarch64 does to the memory at which it failed.
#pragma once

#include <cstdint>

namespace raylab::simt {

// Whether it writes there (Arm Architecture Reference Manual, C4.1, "Loads and stores"). Linux
// tells it too, in a record of a signal's context, but qemu leaves that out.
constexpr bool is_store_aarch64(uint32_t instruction) {
    const auto bits = [instruction](int lowest, int count) {
        return instruction >> lowest & ((1u << count) - 1);
    };
    const bool is_other = !bits(27, 1) || bits(25, 1), is_vector = bits(26, 1);
    const bool is_load = bits(22, 1);
    const uint32_t operation = bits(22, 2);
    if (is_other) return true; // DC ZVA, by which memset() writes zeros
    switch (bits(28, 2)) {
    case 0: // structures of vectors; exclusive and ordered accesses, and compare and swap
        return !is_load || (!is_vector && bits(21, 1) && (bits(23, 1) || !bits(31, 1)));
    case 1: // constants beside the program, which are only loaded; ordered accesses with an offset
        return bits(24, 1) && operation == 0;
    case 2: // pairs
        return !is_load;
    default: // atomic operations; single registers
        if (!bits(24, 1) && bits(21, 1) && bits(10, 2) == 0) return true;
        return operation == 0 || (is_vector && operation == 2);
    }
}

} // namespace raylab::simt
