// How a path begins: with its pixel's camera ray and its random numbers.
//
// The functions are templates over a lab's WavefrontView, what the lab tells its kernels. It has at
// least
//     SceneView scene;
//     RenderSettings settings;
//     std::uint32_t sample; // that this iteration adds to every pixel
//     PoolView pool;        // the lab's: a PathPoolView, and perhaps more
#pragma once

#include "common/camera/camera.h"
#include "common/sampling/sampler.h"
#include "common/wavefront/path_pool.h"

namespace raylab {

// Random numbers belong to a pixel and a sample. A slot's number, or a thread's, must not enter:
// they change with the pool's size, with compaction and with sorting.
template <class WavefrontView> HD Sampler sampler_of(const WavefrontView& wave, int slot) {
    return {wave.settings.sampler, wave.settings.seed, wave.pool.pixel[slot], wave.sample};
}

// Starts the path of `pixel` in the slot.
template <class WavefrontView>
HD void generate_path(const WavefrontView& wave, int slot, std::uint32_t pixel) {
    const PathPoolView& pool = wave.pool;
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

} // namespace raylab
