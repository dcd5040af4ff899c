// The scan in a single pass: decoupled look-back. Merrill and Garland, Single-pass Parallel Prefix
// Scan with Decoupled Look-back, NVIDIA 2016.
//
// Three passes over tiles read and write each number twice, because no tile can start before all
// sums are known. Here a tile publishes its own sum as soon as it has it, and looks back over its
// predecessors, adding up their sums, until it meets one that knows the sum of everything up to
// itself. Each number is read once and written once, as in a copy.
//
// A tile waits for the blocks of earlier tiles, and blocks may start in any order. If block b took
// tile b, blocks with late tiles could fill the device and wait for ever for early tiles, whose
// blocks find no room. So a counter hands out the tiles: a block that gets tile k knows that the
// blocks of tiles 0 to k - 1 have begun.
#include "common/device/device_array.h"
#include "common/task/not_implemented.h"
#include "labs/03_wavefront/scan_tiles.h"
#include "labs/03_wavefront/warp_scan.h"

namespace raylab::lab03 {

namespace {

constexpr int warps = tile_threads / 32;

// What is known of a tile: in the lower half a sum, in the upper half of what. Flag and sum travel
// in one word, which is written and read whole. In two words a __threadfence() would have to stand
// between them on both sides, or a block could see the new flag beside the old sum.
using TileWord = unsigned long long;
constexpr TileWord nothing = 0, of_the_tile = 1ull << 32, of_all_up_to_it = 2ull << 32;

constexpr TileWord kind_of(TileWord word) { return word >> 32 << 32; }
constexpr std::uint32_t sum_of(TileWord word) { return static_cast<std::uint32_t>(word); }

// Where the scan begins in the workspace: the counter of tiles, then a word for each.
struct TileBoard {
    unsigned next_tile;
    unsigned unused; // keeps the words aligned to their size
};

// Reads a word that another block may be about to write: from memory each time, not from a register
// or the multiprocessor's own cache.
__device__ TileWord read_now(const TileWord* word) {
#if defined(__CUDACC__)
    return *static_cast<const volatile TileWord*>(word);
#else
    return __atomic_load_n(word, __ATOMIC_ACQUIRE);
#endif
}

// The sum of all tiles before this one, in every lane. A warp looks at 32 tiles at a time, lane 0
// at the nearest.
__device__ std::uint32_t look_back(const TileWord* words, std::int64_t tile) {
    std::uint32_t before = 0;
    // Steps:
    // 1. Begin at the tile before this one, and look at 32 at a time, lane k at the k-th from
    //    there.
    // 2. Each lane reads its tile's word until it says something. In front of tile 0 a lane has a
    //    complete sum of 0.
    // 3. Vote: which lanes see a complete sum? The lowest of them is the last to be added; without
    //    any it is lane 31.
    // 4. Add the sums of the lanes up to that one, so that every lane knows the total.
    // 5. Return after a complete sum; else go on with the next 32 tiles.
    //[ task 3.7
    const int lane = static_cast<int>(threadIdx.x) % 32;
    for (std::int64_t nearest = tile - 1;; nearest -= 32) {
        const std::int64_t seen = nearest - lane;
        TileWord word = of_all_up_to_it; // in front of the first tile: nothing to add
        if (seen >= 0)
            while ((word = read_now(words + seen)) == nothing) {
            }
        // The nearest tile that knows everything up to itself is the last to be added.
        const unsigned complete = __ballot_sync(all_lanes, kind_of(word) == of_all_up_to_it);
        const int last = complete ? __ffs(complete) - 1 : 31;
        const std::uint32_t upto = warp_inclusive_scan(lane <= last ? sum_of(word) : 0);
        before += __shfl_sync(all_lanes, upto, 31);
        if (complete) return before;
    }
    //| not_implemented("3.7", "scan_lookback: look_back()");
    //]
    return before;
}

// The tile of this block; asked by one thread.
__device__ unsigned take_tile(TileBoard* board) {
    // Steps:
    // 1. Take the number that the board's counter shows and move the counter on, in one operation.
    //[ task 3.7
    return atomicAdd(&board->next_tile, 1u);
    //| not_implemented("3.7", "scan_lookback: take_tile()");
    //| return blockIdx.x;
    //]
}

__global__ void lookback_kernel(const std::uint32_t* in, std::uint32_t* out, std::int64_t n,
                                TileBoard* board, TileWord* words) {
    __shared__ std::int64_t tile;
    __shared__ std::uint32_t warp_sums[warps], before_tile;
    const int t = static_cast<int>(threadIdx.x), warp = t / 32, lane = t % 32;
    if (t == 0) tile = take_tile(board);
    __syncthreads();

    const std::int64_t first = tile * tile_items + t * thread_items;
    std::uint32_t items[thread_items];
    const std::uint32_t own = load_items(in, n, first, items);
    const std::uint32_t upto = warp_inclusive_scan(own);
    if (lane == 31) warp_sums[warp] = upto;
    __syncthreads();

    std::uint32_t before_warp = 0, tile_sum = 0;
    for (int w = 0; w < warps; ++w) {
        if (w < warp) before_warp += warp_sums[w];
        tile_sum += warp_sums[w];
    }
    if (warp == 0) {
        if (lane == 0) atomicExch(&words[tile], of_the_tile | tile_sum); // others need not wait
        const std::uint32_t before = look_back(words, tile);
        if (lane == 0) {
            atomicExch(&words[tile], of_all_up_to_it | (before + tile_sum));
            before_tile = before;
        }
    }
    __syncthreads();
    store_scanned(out, n, first, items, before_tile + before_warp + upto - own);
}

} // namespace

std::int64_t scan_lookback_workspace(std::int64_t n) {
    return (sizeof(TileBoard) + tiles_for(n) * sizeof(TileWord)) / sizeof(std::uint32_t);
}

void scan_lookback(const std::uint32_t* in, std::uint32_t* out, std::int64_t n,
                   std::uint32_t* workspace) {
    if (n == 0) return;
    auto* board = reinterpret_cast<TileBoard*>(workspace);
    auto* words = reinterpret_cast<TileWord*>(board + 1);
    check(cudaMemset(workspace, 0, scan_lookback_workspace(n) * sizeof *workspace), "cudaMemset");
    lookback_kernel<<<static_cast<unsigned>(tiles_for(n)), tile_threads>>>(in, out, n, board,
                                                                           words);
    check(cudaGetLastError(), "lookback_kernel");
}

} // namespace raylab::lab03
