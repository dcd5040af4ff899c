#include "common/render/renderer.h"

#include "common/scene/scene_features.h"

namespace raylab {

Ledger begin_ledger(const Scene& scene, const Camera& camera, const std::string& lab,
                    const std::string& machine) {
    Ledger ledger;
    ledger.lab = lab;
    ledger.machine = machine;
    ledger.scene = scene.name;
    ledger.scene_hash = scene.hash;
    ledger.features = feature_names(features_of(scene, camera));
    ledger.width = camera.width;
    ledger.height = camera.height;
    return ledger;
}

} // namespace raylab
