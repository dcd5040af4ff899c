// Cooperative launches; see cooperative.h.
//
// A grid's barrier is two barriers of each block, and between them one thread of each block that
// waits for those of the others, as operating system threads do.
#include "common/simt/engine/cooperative.h"

#include "common/simt/collectives.h"
#include "common/simt/engine/faults.h"
#include "common/simt/engine/report.h"
#include "common/simt/engine/sanitizer.h"
#include "common/simt/grid_sync.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace raylab::simt {

namespace {

enum class Meeting { all, fault_elsewhere, someone_returned };

// Where the blocks of one launch meet.
class Grid {
  public:
    explicit Grid(uint64_t blocks) : blocks_(blocks) {}

    Meeting wait() {
        std::unique_lock lock(mutex_);
        uint64_t round = round_;
        if (++waiting_ == blocks_) {
            waiting_ = 0;
            ++round_;
            changed_.notify_all();
            return Meeting::all;
        }
        changed_.wait(lock, [&] {
            return round_ != round || failed_ || (ended_ && waiting_ + ended_ >= blocks_);
        });
        if (round_ != round) return Meeting::all;
        changed_.notify_all();
        return failed_ ? Meeting::fault_elsewhere : Meeting::someone_returned;
    }

    void end(const Workers::KernelFault& fault) {
        std::lock_guard lock(mutex_);
        ++ended_;
        if (fault.code != cudaSuccess && !failed_) fault_ = fault;
        failed_ |= fault.code != cudaSuccess;
        changed_.notify_all();
    }

    Workers::KernelFault fault() const { return fault_; }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    uint64_t blocks_, waiting_ = 0, ended_ = 0, round_ = 0;
    bool failed_ = false;
    Workers::KernelFault fault_;
};

constinit thread_local Grid* current_grid = nullptr;

} // namespace

bool in_cooperative_launch() { return current_grid != nullptr; }

void sync_grid(const Site& site) {
    if (!current_block) end_with_message(outside_of_kernel(site));
    if (!current_grid)
        current_block->fail(site, "grid.sync() in a launch that is not cooperative",
                            "launch the kernel with cudaLaunchCooperativeKernel()");
    sync_block(site, 0);
    if (threadIdx.x == 0 && threadIdx.y == 0 && threadIdx.z == 0) {
        Meeting meeting = current_grid->wait();
        if (meeting == Meeting::someone_returned)
            current_block->fail(site, "a block has returned while this one waits at grid.sync()",
                                "let every block of the grid reach the same grid.sync()");
        if (meeting == Meeting::fault_elsewhere)
            current_block->fail(site, "the launch has ended by a fault of another block",
                                "see there");
    }
    sync_block(site, 0);
}

Workers::KernelFault run_cooperative(const Work& work, const Options& options) {
    const dim3& size = work.launch.grid;
    uint64_t blocks = uint64_t(size.x) * size.y * size.z;
    Grid grid(blocks);
    std::vector<std::thread> threads;
#if defined(RAYLAB_CHECK_THREAD)
    Unobserved freeing; // of what CUDA threads used
#endif
    auto run_block = [&](uint3 index) {
#if defined(RAYLAB_CHECK_THREAD)
        Unobserved reading; // of a report that a CUDA thread wrote
#endif
        expect_faults();
        auto block = std::make_unique<Block>(options);
        current_grid = &grid;
        bool good = block->run(work, index);
        current_grid = nullptr;
        grid.end(good ? Workers::KernelFault{}
                      : Workers::KernelFault{block->fault_code(), block->fault()});
    };
    for (unsigned z = 0; z < size.z; ++z)
        for (unsigned y = 0; y < size.y; ++y)
            for (unsigned x = 0; x < size.x; ++x) threads.emplace_back(run_block, uint3{x, y, z});
    for (std::thread& thread : threads) thread.join();
    return grid.fault();
}

} // namespace raylab::simt
