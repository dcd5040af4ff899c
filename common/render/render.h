// Renders: the one loop over samples, and what is made of a film.
#pragma once

#include "common/render/renderer.h"

#include <functional>

namespace raylab {

struct Render {
    Image image; // of as many samples as the ledger has
    Ledger ledger;
};

// The render so far, in place of what `render` was, of a renderer that draws its scene with the
// scene's own seed. The film is copied from the device once, strip by strip: the image is all the
// memory that this takes.
void develop(const Renderer& renderer, const Scene& scene, Render& render);
Render develop(const Renderer& renderer, const Scene& scene);

// Adds `samples` samples to every pixel, or fewer: before each, stop() may end the loop. Calls
// after_sample(done) when another is done, and returns how many were.
int add_samples(Renderer& renderer, int samples,
                const std::function<void(int done)>& after_sample = {},
                const std::function<bool()>& stop = {});

// A whole render of `spp` samples a pixel with this camera and seed. The renderer is restarted, so
// that replicates of a scene share what was built over its shapes.
Render render(Renderer& renderer, const Scene& scene, const Camera& camera, std::uint32_t seed,
              int spp);

} // namespace raylab
