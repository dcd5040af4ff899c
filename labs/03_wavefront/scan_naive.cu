// The naive parallel scan. Hillis and Steele, Data Parallel Algorithms, 1986; GPU Gems 3, 39.2.1.
//
// Round d adds to each element the one 2^d places before it:
//     x[i] <- x[i - 2^d] + x[i].
// After log2(n) rounds each holds the sum of all up to itself. That is n log n additions, against
// n - 1 of the loop. In place it is a race: whether x[i - 2^d] is read before or after it was
// written is chance. Hence two buffers, and each round reads one and writes the other.
#include "common/device/launch.h"
#include "common/task/not_implemented.h"
#include "common/wavefront/grid.h"
#include "labs/03_wavefront/scan.h"

#include <utility>

namespace raylab::lab03 {

namespace {

constexpr int block = 256;

// An exclusive scan is an inclusive one of the numbers moved on by one place.
__global__ void shift_kernel(const std::uint32_t* in, std::uint32_t* out, std::int64_t n) {
    const std::int64_t i = global_index();
    if (i < n) out[i] = i == 0 ? 0 : in[i - 1];
}

__global__ void round_kernel(const std::uint32_t* from, std::uint32_t* to, std::int64_t n,
                             std::int64_t distance) {
    // Steps:
    // 1. Find the number i of this thread in the grid. A thread from n on has nothing to do.
    // 2. Read `from` only: its element i, plus the one `distance` places before it if there is one.
    // 3. Write element i of `to`, in either case.
    //[ task 3.2
    const std::int64_t i = global_index();
    if (i < n) to[i] = i < distance ? from[i] : from[i - distance] + from[i];
    //| not_implemented("3.2", "scan_naive: round_kernel()");
    //]
}

} // namespace

void scan_naive(const std::uint32_t* in, std::uint32_t* out, std::int64_t n,
                std::uint32_t* workspace) {
    if (n == 0) return;
    int rounds = 0;
    while (std::int64_t{1} << rounds < n) ++rounds;
    // The last round must write to out: with an even number of rounds it is where they start, too.
    std::uint32_t *from = rounds % 2 == 0 ? out : workspace,
                  *to = rounds % 2 == 0 ? workspace : out;
    shift_kernel<<<blocks_for(n, block), block>>>(in, from, n);
    check(cudaGetLastError(), "shift_kernel");
    for (int d = 0; d < rounds; ++d, std::swap(from, to)) {
        round_kernel<<<blocks_for(n, block), block>>>(from, to, n, std::int64_t{1} << d);
        check(cudaGetLastError(), "round_kernel");
    }
}

} // namespace raylab::lab03
