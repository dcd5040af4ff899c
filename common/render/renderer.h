// Renderer: what every lab offers, and all that the program, the grader and the tests use of it.
#pragma once

#include "common/film/film.h"
#include "common/film/ledger.h"
#include "common/render/accel_settings.h"
#include "common/render/wavefront_settings.h"
#include "common/scene/features.h"
#include "common/scene/scene.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace raylab {

// The order in which the CPU machine runs the threads of a block, and blocks: a correct kernel
// draws the same image in every order.
enum class ThreadOrder : int { forward, reverse, random };

// How to run, as opposed to what to draw: no field changes a bit of the image.
struct MachineSettings {
    int threads = 0;      // worker threads of the host; 0: one per core
    int block_size = 128; // CUDA threads per block
    ThreadOrder order = ThreadOrder::forward;
    std::uint32_t order_seed = 1;
    WavefrontSettings wavefront = {}; // of labs with a pool of rays
    AccelSettings accel = {};         // of labs with a structure over the triangles
};

// A lab cannot meet these settings for this scene: what() says why, and what would do.
struct SettingsError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Renderer {
  public:
    virtual ~Renderer() = default;

    // Adds one sample to every pixel: one *iteration* of the lecture. The k-th call draws sample k
    // - 1 of each pixel's sequence, so the image after 20 calls is the image of --spp 20.
    virtual void add_iteration() = 0;

    virtual Film film() const = 0; // so far, in host memory
    virtual Ledger ledger() const = 0;

    // What became of each pixel's path in the last iteration, row by row.
    virtual std::vector<PathRecord> records() const = 0;
};

struct Lab {
    std::string number; // "02"
    std::string folder; // "02_iterative"
    std::string title;
    // The scene must outlive the renderer.
    std::unique_ptr<Renderer> (*make)(const Scene& scene, const MachineSettings& machine);
    bool has_pool = false;      // takes pool and memory_budget of MachineSettings::wavefront,
    bool has_wavefront = false; // all the rest of it,
    bool has_accel = false;     // MachineSettings::accel
};

// A ledger that knows its scene and machine, and has counted nothing yet.
Ledger begin_ledger(const Scene& scene, const std::string& lab, const std::string& machine);

// The renderer's image so far, with its provenance.
Image develop(const Renderer& renderer, const Scene& scene);

} // namespace raylab
