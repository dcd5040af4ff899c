// A render that keeps all finished samples when it is interrupted.
#pragma once

#include "app/labs.h"
#include "common/render/render.h"

#include <functional>

namespace raylab::app {

// Draws spp samples. If a signal comes, it ends early and returns the samples that are finished; if
// the ledger has none, there is no image. The render's thread calls after_sample(renderer, done)
// after each sample. The calling thread calls tick() now and then.
//
// The sample that is running when the signal comes gets one second to finish. If it does, the image
// is that of `--spp` with this number of samples, bit for bit. In a large image a sample takes
// longer, and a renderer cannot be stopped within a sample. Then the render's thread is left
// running, and the samples before this one are returned: for that, a copy of image and ledger is
// made about every second, but less often if copying would take more than a fiftieth of the time.
//
// If interrupted() is true afterwards, the renderer may still be using the scene and calling
// after_sample(): end the program with end_interrupted().
Render render_and_keep(const Lab& lab, const Scene& scene, const MachineSettings& machine, int spp,
                       const std::function<void(const Renderer&, int done)>& after_sample,
                       const std::function<void()>& tick);

} // namespace raylab::app
