// cooperative_groups: the group of which only rank, size and barrier are known, and those of a
// whole block and a whole grid.
//
// A group is a small value: a whole block, a whole grid, or lanes of the caller's warp.
#pragma once

#include "common/simt/api/warp.h"
#include "common/simt/grid_sync.h"
#include "common/simt/groups/site_of.h"
#include "common/simt/index.h"

namespace cooperative_groups {

using raylab::simt::Where;

// Also what the special groups become where one is handed to a function by value.
class thread_group {
  public:
    unsigned long long size() const {
        if (kind_ == Kind::lanes) return unsigned(__popc(mask_));
        unsigned long long block = threads_of_block();
        return kind_ == Kind::block ? block : block * gridDim.x * gridDim.y * gridDim.z;
    }
    unsigned long long num_threads() const { return size(); }

    unsigned long long thread_rank() const {
        if (kind_ == Kind::lanes)
            return unsigned(__popc(mask_ & ((1u << raylab::simt::lane_index()) - 1)));
        unsigned long long in_block =
            (threadIdx.z * blockDim.y + threadIdx.y) * blockDim.x + threadIdx.x;
        unsigned long long block =
            ((unsigned long long)blockIdx.z * gridDim.y + blockIdx.y) * gridDim.x + blockIdx.x;
        return kind_ == Kind::block ? in_block : block * threads_of_block() + in_block;
    }

    void sync(Where where = Where::here()) const {
        if (kind_ == Kind::lanes)
            raylab::simt::sync_warp(raylab::simt::site_of("group.sync()", where), mask_);
        else if (kind_ == Kind::block)
            raylab::simt::sync_block(raylab::simt::site_of("group.sync()", where), 0);
        else
            raylab::simt::sync_grid(raylab::simt::site_of("grid.sync()", where));
    }
    bool is_valid() const { return kind_ != Kind::grid || raylab::simt::in_cooperative_launch(); }

  protected:
    enum class Kind { lanes, block, grid };
    thread_group(Kind kind, unsigned mask) : kind_(kind), mask_(mask) {}

    static unsigned threads_of_block() { return blockDim.x * blockDim.y * blockDim.z; }

    Kind kind_;
    unsigned mask_; // of the lanes

    friend thread_group tiled_partition(const thread_group& parent, unsigned size);
};

// All threads of the caller's block.
class thread_block : public thread_group {
  public:
    thread_block() : thread_group(Kind::block, 0) {}
    static unsigned size() { return threads_of_block(); }
    static unsigned num_threads() { return threads_of_block(); }
    static unsigned thread_rank() {
        return (threadIdx.z * blockDim.y + threadIdx.y) * blockDim.x + threadIdx.x;
    }
    static dim3 group_index() { return blockIdx; }
    static dim3 thread_index() { return threadIdx; }
    static dim3 group_dim() { return blockDim; }
    static dim3 dim_threads() { return blockDim; }
};

// All threads of the launch. sync() needs one by cudaLaunchCooperativeKernel().
class grid_group : public thread_group {
  public:
    grid_group() : thread_group(Kind::grid, 0) {}
    static dim3 group_dim() { return gridDim; }
    static dim3 dim_blocks() { return gridDim; }
    static dim3 block_index() { return blockIdx; }
    static unsigned long long num_blocks() {
        return (unsigned long long)gridDim.x * gridDim.y * gridDim.z;
    }
    static unsigned long long block_rank() {
        return ((unsigned long long)blockIdx.z * gridDim.y + blockIdx.y) * gridDim.x + blockIdx.x;
    }
};

inline thread_block this_thread_block() { return {}; }
inline grid_group this_grid() { return {}; }

// The same as functions.
template <class Group> inline void sync(const Group& group, Where where = Where::here()) {
    group.sync(where);
}
template <class Group> inline auto thread_rank(const Group& group) { return group.thread_rank(); }
template <class Group> inline auto group_size(const Group& group) { return group.size(); }

} // namespace cooperative_groups
