// Task 3.6: blocks, blocks in flight, batches: the lecture's sum, and its corners.
#include "common/task/facts.h"
#include "labs/03_wavefront/launch_sizing.h"

namespace raylab::lab03 {

namespace {

using namespace task;

TEST(Task3_6, TheLecturesExample) {
    const LaunchSize ten = launch_size(10 * 128, 128, 4), four = launch_size(4 * 128, 128, 4);
    expect_equal("blocks of 1280 threads, 128 a block", ten.blocks, 10, "threads / block, up");
    expect_equal("batches of 10 blocks in groups of 4", ten.batches, 3, "blocks / in flight, up");
    expect_equal("batches of 4 blocks in groups of 4", four.batches, 1, "blocks / in flight, up");
}

TEST(Task3_6, Corners) {
    expect_equal("blocks of no threads", launch_size(0, 128, 4).blocks, 0, "nothing to launch");
    expect_equal("batches of no blocks", launch_size(0, 128, 4).batches, 0, "nothing to launch");
    expect_equal("blocks of 1 thread", launch_size(1, 1024, 4).blocks, 1, "round up");
    expect_equal("blocks of 129 threads, 128 a block", launch_size(129, 128, 1).blocks, 2,
                 "the last block overhangs");
    expect_equal("blocks of 2^31 threads, 32 a block",
                 launch_size(std::int64_t{1} << 31, 32, 1000).blocks, 1 << 26,
                 "64 bits are needed");
    expect_equal("their batches of 1000", launch_size(std::int64_t{1} << 31, 32, 1000).batches,
                 67109, "blocks / in flight, up");
}

// The scarcest of threads, blocks, registers and shared memory decides.
TEST(Task3_6, TheScarcestResourceDecides) {
    const MultiprocessorLimits has = {2048, 32, 65536, 100 << 10};
    expect_equal("blocks of 256 threads by threads alone", blocks_that_fit(has, {256, 0, 0}), 8,
                 "2048 / 256; needs of 0 are no limit");
    expect_equal("blocks of 32 threads", blocks_that_fit(has, {32, 0, 0}), 32,
                 "no more than the multiprocessor's 32 blocks");
    expect_equal("blocks of 256 threads of 64 registers", blocks_that_fit(has, {256, 64, 0}), 4,
                 "65536 / (256 * 64)");
    expect_equal("blocks of 256 threads with 48 KiB each",
                 blocks_that_fit(has, {256, 32, 48 << 10}), 2, "100 KiB / 48 KiB");
    expect_equal("blocks of 1024 threads of 128 registers", blocks_that_fit(has, {1024, 128, 0}), 0,
                 "such a kernel cannot be launched");
}

} // namespace

} // namespace raylab::lab03
