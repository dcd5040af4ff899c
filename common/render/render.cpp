#include "common/render/render.h"

#include <algorithm>

namespace raylab {

namespace {

constexpr int strip_pixels = 1 << 16; // of some megabytes

Provenance provenance_of(const Scene& scene, const Ledger& ledger) {
    Provenance provenance;
    provenance.scene = scene.name;
    provenance.scene_hash = scene.hash;
    provenance.integrator = scene.render.integrator == Integrator::path ? "path" : "whitted";
    provenance.renderer = ledger.lab;
    provenance.seed = scene.render.seed;
    provenance.spp = ledger.samples;
    provenance.max_depth = scene.render.max_depth;
    return provenance;
}

} // namespace

void develop(const Renderer& renderer, const Scene& scene, Render& render) {
    auto& [image, ledger] = render;
    ledger = renderer.ledger();
    image.width = ledger.width;
    image.height = ledger.height;
    image.mean.resize(image.pixels());
    image.error.resize(image.pixels());
    image.provenance = provenance_of(scene, ledger);
    const int rows = std::max(1, strip_pixels / image.width);
    for (int row = 0; row < image.height; row += rows) {
        const Film strip = renderer.film(row, rows);
        develop(strip, image, static_cast<std::size_t>(row) * image.width);
        for (const FilmPixel& pixel : strip.pixels) ledger.rejected += pixel.rejected;
    }
}

Render develop(const Renderer& renderer, const Scene& scene) {
    Render render;
    develop(renderer, scene, render);
    return render;
}

int add_samples(Renderer& renderer, int samples, const std::function<void(int done)>& after_sample,
                const std::function<bool()>& stop) {
    int done = 0;
    while (done < samples && !(stop && stop())) {
        renderer.add_iteration();
        ++done;
        if (after_sample) after_sample(done);
    }
    return done;
}

Render render(Renderer& renderer, const Scene& scene, const Camera& camera, std::uint32_t seed,
              int spp) {
    renderer.restart(camera, seed);
    add_samples(renderer, spp);
    Render render = develop(renderer, scene);
    render.image.provenance.seed = seed;
    return render;
}

} // namespace raylab
