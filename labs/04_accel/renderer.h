// Lab 04, seen from outside.
#pragma once

#include "common/render/renderer.h"

namespace raylab::lab04 {

class Accel;

// Each structure with each of its walks, as MachineSettings::accel names them.
std::vector<AccelSettings> accels();

// With the structure that `auto` would build, at a guess.
MemoryUse memory_use(const Scene& scene, const MachineSettings& machine);

// Throws SettingsError where settings cannot be met: there is no such walk, or scene, structure and
// film leave no room for a pool. add_iteration() throws EndlessWalk if a walk does not end.
std::unique_ptr<Renderer> make_renderer(const Scene& scene, const MachineSettings& machine);

// The same with a structure over the scene's triangles that is built already.
std::unique_ptr<Renderer> make_renderer(const Scene& scene, const MachineSettings& machine,
                                        Accel accel);

} // namespace raylab::lab04
