// A render of which nothing is lost when it is interrupted.
#pragma once

#include "app/labs.h"
#include "common/render/render.h"

#include <functional>

namespace raylab::app {

// Draws spp samples, or as many as are finished when a signal comes: if the ledger has none, there
// is no image. after_sample(renderer, done) is called on the render's thread, tick() every now and
// then on this one.
//
// The sample that is running when the signal comes has a second to be finished: the image is then
// that of `--spp` so many, bit for bit. A sample of a large image takes longer, and a renderer
// cannot be stopped within one: it is given up, and the samples before it are kept. For that, image
// and ledger are set aside every second or so, where they take at most a fiftieth of the time.
//
// If interrupted() afterwards, the renderer may still be at work on the scene, and after_sample()
// be called: end with end_interrupted().
Render render_and_keep(const Lab& lab, const Scene& scene, const MachineSettings& machine, int spp,
                       const std::function<void(const Renderer&, int done)>& after_sample,
                       const std::function<void()>& tick);

} // namespace raylab::app
