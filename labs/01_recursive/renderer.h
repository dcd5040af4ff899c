// Lab 01, seen from outside.
#pragma once

#include "common/render/renderer.h"

namespace raylab::lab01 {

MemoryUse memory_use(const Scene& scene, const MachineSettings& machine);

std::unique_ptr<Renderer> make_renderer(const Scene& scene, const MachineSettings& machine);

} // namespace raylab::lab01
