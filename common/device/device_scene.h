// DeviceScene: a copy of a scene's arrays in device memory, and the SceneView that points to them.
#pragma once

#include "common/device/device_array.h"
#include "common/scene/scene_arrays.h"
#include "common/scene/set_camera.h"

#include <cstddef>

namespace raylab {

class DeviceScene {
  public:
    explicit DeviceScene(const Scene& scene) : view_(raylab::view(scene)) {
        for_each_array(scene, view_, [this]<class T>(const std::vector<T>& items, Array<T>& array) {
            const auto& memory = memory_.emplace_back(std::as_bytes(std::span(items)));
            array.data = reinterpret_cast<const T*>(memory.data());
        });
    }

    const SceneView& view() const { return view_; }

    // Throws as the function of this name does (common/scene/set_camera.h).
    void set_camera(const Camera& camera) { raylab::set_camera(view_, camera); }

  private:
    std::vector<DeviceArray<std::byte>> memory_; // one for each array
    SceneView view_;
};

} // namespace raylab
