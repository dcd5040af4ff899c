// Stage 1: a path for every pixel of the batch, each with its camera ray.
#pragma once

#include "common/camera/camera.h"
#include "labs/04_accel/wave.h"

namespace raylab::lab04 {

// Starts the path of `pixel` in the slot.
HD void generate_path(const Wave& wave, int slot, std::uint32_t pixel) {
    const PoolView& pool = wave.pool;
    const Camera& camera = wave.scene.camera;
    pool.pixel[slot] = pixel;
    const Sampler sampler = sampler_of(wave, slot);
    const Ray ray = generate_ray(
        camera, static_cast<int>(pixel % camera.width), static_cast<int>(pixel / camera.width),
        film_point(wave.settings.jitter, sampler),
        camera.lens_radius > 0 ? sampler.get_2d(dimension::lens) : Vec2(0));
    pool.origin[slot] = ray.o;
    pool.direction[slot] = ray.d;
    pool.bounce[slot] = 0;
    pool.throughput[slot] = Vec3(1);
    pool.radiance[slot] = Vec3(0);
    pool.bsdf_pdf[slot] = delta_pdf;
    pool.record[slot] = {};
    pool.alive[slot] = 1;
    if (pool.stack == nullptr) return;
    pool.node[slot] = 1; // the root of Whitted's tree
    pool.pending[slot] = 0;
}

} // namespace raylab::lab04
