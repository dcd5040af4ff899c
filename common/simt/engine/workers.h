// The persistent threads that run the blocks of a launch.
//
// The caller is worker 0. Blocks are handed out in chunks from a counter, in order; so the lowest
// block that is not finished is always running, and a kernel may wait for lower blocks.
#pragma once

#include "common/simt/engine/block.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace raylab::simt {

class Workers {
  public:
    Workers(const Options& options, int count);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    // Runs every block of the launch. Returns a fault, or nothing.
    struct KernelFault {
        cudaError_t code = cudaSuccess;
        std::string report;
    };
    KernelFault run(const Work& work);

  private:
    struct Job;
    void serve(int worker);
    void take_part(Block& block, Job& job);

    Options options_;
    std::vector<std::unique_ptr<Block>> blocks_; // one for each worker
    std::vector<std::thread> threads_;           // of workers 1, 2, ...

    // A new generation is a new job. While it is open, workers that wake up take part in it; the
    // caller closes it when no block is left, and waits only for those who did.
    std::atomic<uint32_t> generation_{0};
    std::atomic<bool> open_{false}, quit_{false};
    std::atomic<int> active_{0};
    Job* job_ = nullptr;
};

} // namespace raylab::simt
