// Lab 03, seen from outside.
#pragma once

#include "common/render/renderer.h"

namespace raylab::lab03 {

MemoryUse memory_use(const Scene& scene, const MachineSettings& machine);

// Throws SettingsError where settings cannot be met: scene and film leave no room for a pool, a
// first-bounce cache would be wrong, the geometry is too large for shared memory.
std::unique_ptr<Renderer> make_renderer(const Scene& scene, const MachineSettings& machine);

} // namespace raylab::lab03
