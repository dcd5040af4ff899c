// The ray pool of lab 03, with room for what walks find.
//
// Slots stay where they are while a path lives; what moves is the list of the slots that are alive.
// A path's rays are traced in two steps, by a walk through the triangles and by a test of the other
// shapes, so the hit is passed on through the pool from the one to the other.
// Laine, Karras and Aila, Megakernels Considered Harmful, HPG 2013, section 4.
#pragma once

#include "common/device/device_array.h"
#include "common/film/ledger.h"
#include "common/geometry/ray.h"
#include "common/transport/emission.h"

namespace raylab::lab04 {

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
    Vec3* radiance;  // belongs to the film once the path ends
    float* bsdf_pdf; // density of the ray's direction
    std::uint8_t* alive;
    PathRecord* record;
    // The ray to be traced next, and what it hit: the closest triangle first, then any shape.
    Vec3* origin;
    Vec3* direction;
    Hit* hit;
    // The shadow ray on its way.
    Vec3* shadow_ray_origin;
    Vec3* shadow_ray_direction;
    float* shadow_ray_t_max;
    Vec3* shadow_ray_light; // what is gained if the shadow ray meets nothing
    std::uint8_t* blocked;  // by a triangle
    // Whitted's tree: the light that its shadow rays found here, and its branches still to be
    // traced. Branch k of slot s is stack[k capacity + s].
    Vec3* direct;
    std::uint32_t* node;
    int* pending;
    PendingRay* stack;
    int capacity; // slots
};

// What a path costs, and what Whitted's branches cost on top: at most one is pending on each level
// that can split, which leaves out the last.
constexpr std::size_t path_bytes = sizeof(std::uint32_t) + sizeof(int) + 2 * sizeof(Vec3) +
                                   sizeof(float) + sizeof(std::uint8_t) + sizeof(PathRecord) +
                                   2 * sizeof(Vec3) + sizeof(Hit) + 3 * sizeof(Vec3) +
                                   sizeof(float) + sizeof(std::uint8_t);
static_assert(path_bytes == 130, "as in lab 03");

constexpr std::size_t branch_bytes(int branches) {
    return branches == 0
               ? 0
               : sizeof(Vec3) + sizeof(std::uint32_t) + sizeof(int) + branches * sizeof(PendingRay);
}

// The arrays' memory.
class Pool {
  public:
    // branches: room for Whitted's pending rays; 0 for path tracing.
    Pool(int capacity, int branches)
        : pixel_(capacity), bounce_(capacity), throughput_(capacity), radiance_(capacity),
          bsdf_pdf_(capacity), alive_(capacity), record_(capacity), origin_(capacity),
          direction_(capacity), hit_(capacity), shadow_ray_origin_(capacity),
          shadow_ray_direction_(capacity), shadow_ray_t_max_(capacity), shadow_ray_light_(capacity),
          blocked_(capacity), direct_(branches > 0 ? capacity : 0),
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
                shadow_ray_origin_.data(),
                shadow_ray_direction_.data(),
                shadow_ray_t_max_.data(),
                shadow_ray_light_.data(),
                blocked_.data(),
                direct_.data(),
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
    DeviceArray<Vec3> shadow_ray_origin_, shadow_ray_direction_;
    DeviceArray<float> shadow_ray_t_max_;
    DeviceArray<Vec3> shadow_ray_light_;
    DeviceArray<std::uint8_t> blocked_;
    DeviceArray<Vec3> direct_;
    DeviceArray<std::uint32_t> node_;
    DeviceArray<int> pending_;
    DeviceArray<PendingRay> stack_;
    int capacity_;
};

HD Ray ray_of(const PoolView& pool, int slot) { return {pool.origin[slot], pool.direction[slot]}; }

HD Ray shadow_ray_of(const PoolView& pool, int slot) {
    return {pool.shadow_ray_origin[slot], pool.shadow_ray_direction[slot],
            pool.shadow_ray_t_max[slot]};
}

// light: what is gained if nothing is in its way.
HD void send_shadow_ray(const PoolView& pool, int slot, const Ray& shadow_ray, Vec3 light) {
    pool.shadow_ray_origin[slot] = shadow_ray.o;
    pool.shadow_ray_direction[slot] = shadow_ray.d;
    pool.shadow_ray_t_max[slot] = shadow_ray.t_max;
    pool.shadow_ray_light[slot] = light;
    record_shadow_ray(pool.record[slot]);
}

// The path in this slot is done: no stage touches it again, until its colour is accumulated.
HD void end_path(const PoolView& pool, int slot, PathEnd end) {
    pool.record[slot].end = end;
    pool.alive[slot] = 0;
}

} // namespace raylab::lab04
