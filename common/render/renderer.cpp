#include "common/render/renderer.h"
#include "common/scene/scene_features.h"

#include <algorithm>

namespace raylab {

Ledger begin_ledger(const Scene& scene, const std::string& lab, const std::string& machine) {
    Ledger ledger;
    ledger.lab = lab;
    ledger.machine = machine;
    ledger.scene = scene.name;
    ledger.scene_hash = scene.hash;
    ledger.features = feature_names(features_of(scene));
    ledger.width = scene.camera.width;
    ledger.height = scene.camera.height;
    return ledger;
}

namespace {

// Calls use(strip, first_row) for one part of the film after the other, each of some megabytes.
template <class Use>
void for_each_strip(const Renderer& renderer, int width, int height, const Use& use) {
    const int rows = std::max(1, (1 << 16) / width);
    for (int row = 0; row < height; row += rows) use(renderer.film(row, rows), row);
}

} // namespace

void develop(const Renderer& renderer, const Scene& scene, const Ledger& ledger, Image& image) {
    image.width = scene.camera.width;
    image.height = scene.camera.height;
    image.mean.resize(image.pixels());
    image.error.resize(image.pixels());
    for_each_strip(renderer, image.width, image.height, [&](const Film& strip, int first_row) {
        develop(strip, image, static_cast<std::size_t>(first_row) * image.width);
    });
    image.provenance.scene = scene.name;
    image.provenance.scene_hash = scene.hash;
    image.provenance.integrator = scene.render.integrator == Integrator::path ? "path" : "whitted";
    image.provenance.renderer = ledger.lab;
    image.provenance.seed = scene.render.seed;
    image.provenance.spp = ledger.samples;
    image.provenance.max_depth = scene.render.max_depth;
}

Image develop(const Renderer& renderer, const Scene& scene) {
    Image image;
    develop(renderer, scene, renderer.ledger(), image);
    return image;
}

std::uint64_t rejected_samples(const Renderer& renderer, int width, int height) {
    std::uint64_t rejected = 0;
    for_each_strip(renderer, width, height, [&](const Film& strip, int) {
        for (const FilmPixel& pixel : strip.pixels) rejected += pixel.rejected;
    });
    return rejected;
}

} // namespace raylab
