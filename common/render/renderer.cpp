#include "common/render/renderer.h"

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

Image develop(const Renderer& renderer, const Scene& scene) {
    Image image = develop(renderer.film());
    const Ledger ledger = renderer.ledger();
    image.provenance.scene = scene.name;
    image.provenance.scene_hash = scene.hash;
    image.provenance.integrator = scene.render.integrator == Integrator::path ? "path" : "whitted";
    image.provenance.renderer = ledger.lab;
    image.provenance.seed = scene.render.seed;
    image.provenance.spp = ledger.samples;
    image.provenance.max_depth = scene.render.max_depth;
    return image;
}

} // namespace raylab
