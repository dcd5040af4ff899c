// The ray pool: what a path must keep from one launch to the next.
//
// A megakernel keeps its path in registers from the camera to the end. A kernel that traces ONE
// bounce must store the path in memory. The pool is a *structure of arrays*: the threads of a warp
// read the same field of neighbouring slots, so their 32 reads fall into few sectors of memory. A
// path stays in its slot as long as it lives; only the list of the slots that are alive changes.
// Laine, Karras and Aila, Megakernels Considered Harmful, HPG 2013, section 4.
#pragma once

#include "common/film/ledger.h"
#include "common/geometry/ray.h"
#include "common/transport/emission.h"
#include "common/wavefront/slot_arrays.h"

namespace raylab {

// A branch of Whitted's tree that waits for its turn. node: see sampler.h, shadow_ray_dimension().
struct PendingRay {
    Vec3 origin, direction, throughput;
    int depth; // surfaces touched before
    std::uint32_t node;
};

// The arrays as kernels see them, one entry a slot. A slot holds one path at a time. A lab's pool
// derives from this and adds its own.
struct PathPoolView : SlotArrays {
    int branches; // room for Whitted's pending rays; 0 for path tracing

    constexpr explicit PathPoolView(int branches, SlotMemory* memory = nullptr)
        : SlotArrays(memory), branches(branches) {}

    // The path.
    std::uint32_t* pixel = deal();
    int* bounce = deal(); // surfaces touched before; counts the random numbers' dimensions too
    Vec3* throughput = deal();
    Vec3* radiance = deal();  // the lecture's "unaccumulated colour": the film's once the path ends
    float* bsdf_pdf = deal(); // density of the ray's direction
    std::uint8_t* alive = deal();
    PathRecord* record = deal();
    // The ray to be traced next, and what it hit.
    Vec3* origin = deal();
    Vec3* direction = deal();
    Hit* hit = deal(); // 16 bytes, read and written as one
    // The shadow ray on its way.
    Vec3* shadow_ray_origin = deal();
    Vec3* shadow_ray_direction = deal();
    float* shadow_ray_t_max = deal();
    Vec3* shadow_ray_light = deal(); // what the path gains if the shadow ray meets nothing
    // Whitted's tree: its branches still to be traced. Branch k of slot s is stack[k capacity + s].
    std::uint32_t* node = deal(branches > 0);
    int* pending = deal(branches > 0);
    PendingRay* stack = deal(branches);
};

HD Ray ray_of(const PathPoolView& pool, int slot) {
    return {pool.origin[slot], pool.direction[slot]};
}

HD Ray shadow_ray_of(const PathPoolView& pool, int slot) {
    return {pool.shadow_ray_origin[slot], pool.shadow_ray_direction[slot],
            pool.shadow_ray_t_max[slot]};
}

// light: what is gained if nothing is in the shadow ray's way.
HD void send_shadow_ray(const PathPoolView& pool, int slot, const Ray& shadow_ray, Vec3 light) {
    pool.shadow_ray_origin[slot] = shadow_ray.o;
    pool.shadow_ray_direction[slot] = shadow_ray.d;
    pool.shadow_ray_t_max[slot] = shadow_ray.t_max;
    pool.shadow_ray_light[slot] = light;
    record_shadow_ray(pool.record[slot]);
}

// The path in this slot is done: no stage touches it again, until its colour is accumulated.
HD void end_path(const PathPoolView& pool, int slot, PathEnd end) {
    pool.record[slot].end = end;
    pool.alive[slot] = 0;
}

} // namespace raylab
