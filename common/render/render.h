// Renders: the one loop over samples, and what is made of a film.
#pragma once

#include "common/render/renderer.h"

#include <functional>

namespace raylab {

struct Render {
    Image image; // of as many samples as the ledger has
    Ledger ledger;
};

// Writes the image and the ledger so far to `render`, for a renderer that draws its scene with the
// scene's own seed. The film is copied from the device once, strip by strip, so this takes no
// memory beside the image.
void develop(const Renderer& renderer, const Scene& scene, Render& render);
Render develop(const Renderer& renderer, const Scene& scene);

// Adds `samples` samples to every pixel, or fewer if stop() returns true before one of them. Calls
// after_sample(done) after each sample. Returns the number of samples that were added.
int add_samples(Renderer& renderer, int samples,
                const std::function<void(int done)>& after_sample = {},
                const std::function<bool()>& stop = {});

// A whole render of `spp` samples a pixel with this camera and seed. The renderer is restarted, so
// that replicates of a scene share what was built over its shapes.
Render render(Renderer& renderer, const Scene& scene, const Camera& camera, std::uint32_t seed,
              int spp);

} // namespace raylab
