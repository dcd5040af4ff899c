// Lab 02's device code in a plain threaded loop: what the speed tests compare with.
#pragma once

#include "common/camera/camera.h"
#include "common/film/film.h"
#include "common/scene/view.h"
#include "labs/02_iterative/path.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace raylab::lab02 {

// One sample of every pixel, rows handed out to threads one by one.
template <Features F>
void plain_loop(const SceneView& scene, const RenderSettings& settings, std::uint32_t sample,
                int thread_count, std::vector<FilmPixel>& film, std::vector<PathRecord>& records) {
    std::atomic<int> next_row = 0;
    const auto work = [&] {
        for (int y = next_row++; y < scene.camera.height; y = next_row++)
            for (int x = 0; x < scene.camera.width; ++x) {
                const int pixel = y * scene.camera.width + x;
                const Sampler sampler = {settings.sampler, settings.seed,
                                         static_cast<std::uint32_t>(pixel), sample};
                const Vec2 u_lens = F & feature::lens ? sampler.get_2d(dimension::lens) : Vec2(0);
                const Ray ray =
                    generate_ray(scene.camera, x, y, sampler.get_2d(dimension::film), u_lens);
                PathRecord record;
                add_sample(film[pixel], trace_path<F>(scene, settings, sampler, ray, record));
                records[pixel] = record;
            }
    };
    std::vector<std::thread> threads;
    for (int i = 0; i < thread_count; ++i) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
}

inline double seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace raylab::lab02
