// The ray pool: all that a path must not forget from one launch to the next.
//
// A megakernel keeps its path in registers from the camera to the end. Kernels that trace ONE
// bounce write it down. It lies as a *structure of arrays*: the threads of a warp read the same
// field of neighbouring slots, so their 32 reads fall into few sectors of memory. Slots stay where
// they are while a path lives; what moves is the list of the slots that are alive.
// Laine, Karras and Aila, Megakernels Considered Harmful, HPG 2013, section 4.
#pragma once

#include "common/device/device_array.h"
#include "common/film/ledger.h"
#include "common/geometry/ray.h"
#include "common/transport/emission.h"

namespace raylab::lab03 {

// A branch of Whitted's tree that waits for its turn. node: see sampler.h, shadow_ray_dimension().
struct PendingRay {
    Vec3 origin, direction, throughput;
    int depth; // surfaces touched before
    std::uint32_t node;
};

// The arrays as kernels see them, one entry a slot. A slot holds one path at a time.
struct PoolView {
    // The path.
    std::uint32_t* pixel;
    int* bounce; // surfaces touched before; counts the random numbers' dimensions too
    Vec3* throughput;
    Vec3* radiance;  // the lecture's "unaccumulated colour": belongs to the film once the path ends
    float* bsdf_pdf; // density of the ray's direction
    std::uint8_t* alive;
    PathRecord* record;
    // The ray to be traced next, and what it hit.
    Vec3* origin;
    Vec3* direction;
    Hit* hit;           // 16 bytes, read and written as one
    std::uint8_t* kind; // of the material that was hit; no_kind: nothing to shade
    // The shadow ray on its way.
    Vec3* shadow_ray_origin;
    Vec3* shadow_ray_direction;
    float* shadow_ray_t_max;
    Vec3* shadow_ray_light; // what the path gains if the shadow ray meets nothing
    // Whitted's tree: its branches still to be traced. Branch k of slot s is stack[k capacity + s].
    std::uint32_t* node;
    int* pending;
    PendingRay* stack;
    int capacity; // slots
};

// What a path costs. Whitted's branches come on top: at most one is pending on each level that can
// split, which leaves out the last.
constexpr std::size_t path_bytes = sizeof(std::uint32_t) + sizeof(int) + 2 * sizeof(Vec3) +
                                   sizeof(float) + sizeof(std::uint8_t) + sizeof(PathRecord) +
                                   2 * sizeof(Vec3) + sizeof(Hit) + sizeof(std::uint8_t) +
                                   3 * sizeof(Vec3) + sizeof(float);
static_assert(path_bytes == 130, "the handout and --memory-budget promise 130 bytes a path");

constexpr std::size_t branch_bytes(int branches) {
    return branches == 0 ? 0 : sizeof(std::uint32_t) + sizeof(int) + branches * sizeof(PendingRay);
}

// PoolView::kind of a slot whose ray hit nothing: nothing to shade.
constexpr std::uint8_t no_kind = 7;

// The arrays' memory.
class Pool {
  public:
    // branches: room for Whitted's pending rays; 0 for path tracing.
    Pool(int capacity, int branches)
        : pixel_(capacity), bounce_(capacity), throughput_(capacity), radiance_(capacity),
          bsdf_pdf_(capacity), alive_(capacity), record_(capacity), origin_(capacity),
          direction_(capacity), hit_(capacity), kind_(capacity), shadow_ray_origin_(capacity),
          shadow_ray_direction_(capacity), shadow_ray_t_max_(capacity), shadow_ray_light_(capacity),
          node_(branches > 0 ? capacity : 0), pending_(branches > 0 ? capacity : 0),
          stack_(static_cast<std::size_t>(branches) * capacity), capacity_(capacity) {}

    PoolView view() {
        return {pixel_.data(),
                bounce_.data(),
                throughput_.data(),
                radiance_.data(),
                bsdf_pdf_.data(),
                alive_.data(),
                record_.data(),
                origin_.data(),
                direction_.data(),
                hit_.data(),
                kind_.data(),
                shadow_ray_origin_.data(),
                shadow_ray_direction_.data(),
                shadow_ray_t_max_.data(),
                shadow_ray_light_.data(),
                node_.data(),
                pending_.data(),
                stack_.data(),
                capacity_};
    }

  private:
    DeviceArray<std::uint32_t> pixel_;
    DeviceArray<int> bounce_;
    DeviceArray<Vec3> throughput_, radiance_;
    DeviceArray<float> bsdf_pdf_;
    DeviceArray<std::uint8_t> alive_;
    DeviceArray<PathRecord> record_;
    DeviceArray<Vec3> origin_, direction_;
    DeviceArray<Hit> hit_;
    DeviceArray<std::uint8_t> kind_;
    DeviceArray<Vec3> shadow_ray_origin_, shadow_ray_direction_;
    DeviceArray<float> shadow_ray_t_max_;
    DeviceArray<Vec3> shadow_ray_light_;
    DeviceArray<std::uint32_t> node_;
    DeviceArray<int> pending_;
    DeviceArray<PendingRay> stack_;
    int capacity_;
};

// The path in this slot is done: no stage touches it again, until its colour is accumulated.
HD void end_path(const PoolView& pool, int slot, PathEnd end) {
    pool.record[slot].end = end;
    pool.alive[slot] = 0;
}

} // namespace raylab::lab03
