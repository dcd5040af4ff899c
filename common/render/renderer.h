// Renderer: what every lab offers, and all that the program, the grader and the tests use of it.
#pragma once

#include "common/film/film.h"
#include "common/film/ledger.h"
#include "common/math/features.h"
#include "common/render/accel_settings.h"
#include "common/render/wavefront_settings.h"
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
    bool records = true; // keep a PathRecord for each pixel; tests read them, pictures need none
};

// Thrown if a lab cannot meet these settings for this scene. what() says why, and which settings
// would work.
struct SettingsError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Renderer {
  public:
    virtual ~Renderer() = default;

    // Adds one sample to every pixel: one *iteration* of the lecture. The k-th call draws sample k
    // - 1 of each pixel's sequence, so the image after 20 calls is the image of --spp 20.
    virtual void add_iteration() = 0;

    // Begins anew with another camera and seed: the film is empty, sample 0 comes next, and every
    // bit from here on is that of a new renderer of a scene with this camera and seed. What was
    // built over the shapes stays. Throws std::invalid_argument if the camera's film has another
    // size, SettingsError if the settings cannot be met with this camera; then nothing has changed.
    virtual void restart(const Camera& camera, std::uint32_t seed) = 0;

    // The film so far, in host memory: `rows` of its rows from first_row on, or as many as there
    // are.
    virtual Film film(int first_row = 0, int rows = max_film_side) const = 0;

    // What was counted so far: all but Ledger::rejected, which develop() (render.h) adds up while
    // it reads the film.
    virtual Ledger ledger() const = 0;

    // What became of each pixel's path in the last iteration, row by row. For renderers that were
    // made with MachineSettings::records.
    virtual std::vector<PathRecord> records() const = 0;
};

// Bytes that a renderer takes beside its scene.
struct MemoryUse {
    std::size_t pixel; // for each pixel of the film
    std::size_t fixed; // pool and structure
};

struct Lab {
    std::string number; // "02"
    std::string folder; // "02_iterative"
    std::string title;
    // The scene must outlive the renderer.
    std::unique_ptr<Renderer> (*make)(const Scene& scene, const MachineSettings& machine);
    MemoryUse (*memory)(const Scene& scene, const MachineSettings& machine);
    bool has_pool = false;      // takes pool and memory_budget of MachineSettings::wavefront,
    bool has_wavefront = false; // all the rest of it,
    // What MachineSettings::accel may name, each structure with each of its walks; null: nothing.
    std::vector<AccelSettings> (*accels)() = nullptr;
};

// A ledger that knows what is drawn and by whom, and has counted nothing yet. camera: the scene's,
// or that of Renderer::restart().
Ledger begin_ledger(const Scene& scene, const Camera& camera, const std::string& lab,
                    const std::string& machine);

} // namespace raylab
