// A sky of flat texels for a renderer that interpolates between them.
#pragma once

#include "common/image/image.h"
#include "common/scene/scene.h"

namespace raylab::app::mitsuba {

// The scene's environment map, finer. Its edges become ramps that keep the integral of the steps.
Image fine_sky(const Scene& scene);

} // namespace raylab::app::mitsuba
