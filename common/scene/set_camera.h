// Another camera before the same shapes.
#pragma once

#include "common/scene/view.h"

#include <stdexcept>

namespace raylab {

// Throws std::invalid_argument if the camera's film has another size than the one before.
inline void set_camera(SceneView& view, const Camera& camera) {
    if (camera.width != view.camera.width || camera.height != view.camera.height)
        throw std::invalid_argument("set_camera: the film must keep its size");
    view.camera = camera;
}

} // namespace raylab
