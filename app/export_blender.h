// A scene as Blender's path tracer Cycles draws it, to compare speed and error with. One Python
// file that Blender runs: `blender -b --python scene.py -- --spp 64 -o image.exr`. It holds the
// scene and the code that builds it (export_blender.py).
//
// The export keeps the camera, the box pixel filter and the number of scattering events. Cycles
// writes a linear EXR without denoiser, clamp or light threshold. Where the two renderers differ,
// and what the export does about it:
//   spheres    Cycles has triangles only. A sphere becomes 81,920 triangles with smooth normals.
//              Their corners lie on the sphere, their faces up to 4e-5 radius inside.
//   depth      max_depth surfaces are max_depth - 2 of Cycles' bounces: the first surface is no
//              bounce, and the last is the light's.
// Refused: everything but quads, flat triangles and spheres of diffuse, mirror, clear glass and
// glowing diffuse material; lens, point lights, environments, textures, the whitted integrator.
#pragma once

#include "app/export_mitsuba.h"

namespace raylab::app {

// scene.py alone. Throws UsageError with one sentence about what the export does not know.
std::vector<ExportedFile> blender_files(const Scene& scene);

} // namespace raylab::app
