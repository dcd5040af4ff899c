// A scene as Mitsuba 3 reads it, so that a renderer that shares no code with ours can be asked for
// the same picture. https://mitsuba.readthedocs.io, XML scene format, version 3.
//
// Where the two differ, and what is done about it:
//   lights      Mitsuba's area lights shine from one side: a second face lies close behind each.
//   planes      have no end here; there they become squares 65536 times as large as the rest.
//   maps        the sky is piecewise constant here and interpolated there: it is written 8 x 32
//               times as fine, with the edges of our texels half way up the ramps. What is left
//               shows along a bright edge seen directly (2 % of a pixel row, where 8 x 8 gave 8 %).
//   glass       Mitsuba divides radiance by eta^2 where it enters glass and multiplies where it
//               leaves. So images are the same, except for a light inside glass.
// Refused: Phong (Mitsuba 3 has none), Schlick's approximation, the whitted integrator, glowing
// surfaces with shading normals.
#pragma once

#include "common/scene/scene.h"

namespace raylab::app {

struct ExportedFile {
    std::string name, bytes;
};

// scene.xml and the files that it names. Throws UsageError with one sentence about what Mitsuba
// cannot express.
std::vector<ExportedFile> mitsuba_files(const Scene& scene);

} // namespace raylab::app
