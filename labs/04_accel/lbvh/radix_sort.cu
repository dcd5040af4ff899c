// One pass for each digit of eight bits. As in lab 03's split by one bit, a pass has three steps:
//     count    how often each digit occurs in each chunk of the numbers,
//     scan     hence where the first number of a chunk with this digit belongs,
//     scatter  each number to its place.
// One thread goes through a chunk from front to end. So numbers with the same digit keep their
// order, and no two threads write to the same counter. The table lies digit by digit. So one scan
// over all of it counts the numbers with smaller digits and those with the same digit in the chunks
// before. Satish, Harris and Garland, Designing Efficient Sorting Algorithms for Manycore GPUs,
// IPDPS 2009.
#include "labs/04_accel/lbvh/radix_sort.h"

#include "common/device/launch.h"
#include "common/wavefront/grid.h"
#include "common/wavefront/scan_library.h"

#include <utility>

namespace raylab::lab04 {

namespace {

constexpr int digit_bits = 8, digits = 1 << digit_bits;
constexpr int chunk = 1024, block = 64;

__device__ int digit_of(std::uint32_t key, int shift) { return key >> shift & (digits - 1); }

__global__ void count_digits(const std::uint32_t* keys, int n, int shift, int chunks,
                             std::uint32_t* table) {
    const int c = static_cast<int>(global_index());
    if (c >= chunks) return;
    std::uint32_t count[digits] = {};
    for (int i = c * chunk; i < n && i < (c + 1) * chunk; ++i) ++count[digit_of(keys[i], shift)];
    for (int d = 0; d < digits; ++d) table[std::int64_t{d} * chunks + c] = count[d];
}

__global__ void scatter(const std::uint32_t* keys, const int* values, int n, int shift, int chunks,
                        const std::uint32_t* table, std::uint32_t* sorted_keys,
                        int* sorted_values) {
    const int c = static_cast<int>(global_index());
    if (c >= chunks) return;
    std::uint32_t place[digits];
    for (int d = 0; d < digits; ++d) place[d] = table[std::int64_t{d} * chunks + c];
    for (int i = c * chunk; i < n && i < (c + 1) * chunk; ++i) {
        const std::uint32_t to = place[digit_of(keys[i], shift)]++;
        sorted_keys[to] = keys[i];
        sorted_values[to] = values[i];
    }
}

} // namespace

void radix_sort(DeviceArray<std::uint32_t>& keys, DeviceArray<int>& values, int bits) {
    const int n = static_cast<int>(keys.size());
    if (n == 0) return;
    const int chunks = parts_for(n, chunk), blocks = blocks_for(chunks, block);
    const std::int64_t entries = std::int64_t{digits} * chunks;
    DeviceArray<std::uint32_t> other_keys(n), count(entries), place(entries),
        workspace(scan_library_workspace(entries));
    DeviceArray<int> other_values(n);
    for (int shift = 0; shift < bits; shift += digit_bits) {
        count_digits<<<blocks, block>>>(keys.data(), n, shift, chunks, count.data());
        scan_library(count.data(), place.data(), entries, workspace.data());
        scatter<<<blocks, block>>>(keys.data(), values.data(), n, shift, chunks, place.data(),
                                   other_keys.data(), other_values.data());
        check(cudaGetLastError(), "radix_sort");
        std::swap(keys, other_keys);
        std::swap(values, other_values);
    }
}

} // namespace raylab::lab04
