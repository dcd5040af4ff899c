// The list of labs that the program knows: the one place that includes all of them. A student's
// tree has one lab alone.
#include "app/labs.h"
#if __has_include("labs/01_recursive/renderer.h")
#include "labs/01_recursive/renderer.h"
#endif
#if __has_include("labs/02_iterative/renderer.h")
#include "labs/02_iterative/renderer.h"
#endif
#if __has_include("labs/03_wavefront/renderer.h")
#include "labs/03_wavefront/renderer.h"
#endif
#if __has_include("labs/04_accel/renderer.h")
#include "labs/04_accel/renderer.h"
#endif

#include <fmt/format.h>

namespace raylab::app {

const std::vector<Lab>& labs() {
    static const std::vector<Lab> all = {
#if __has_include("labs/01_recursive/renderer.h")
        {.number = "01",
         .folder = "01_recursive",
         .title = "the recursive tracer, plain C++",
         .make = lab01::make_renderer,
         .memory = lab01::memory_use},
#endif
#if __has_include("labs/02_iterative/renderer.h")
        {.number = "02",
         .folder = "02_iterative",
         .title = "the iterative kernel, one CUDA thread a pixel",
         .make = lab02::make_renderer,
         .memory = lab02::memory_use},
#endif
#if __has_include("labs/03_wavefront/renderer.h")
        {.number = "03",
         .folder = "03_wavefront",
         .title = "the wavefront: a pool of rays, one launch a stage and bounce",
         .make = lab03::make_renderer,
         .memory = lab03::memory_use,
         .has_pool = true,
         .has_wavefront = true},
#endif
#if __has_include("labs/04_accel/renderer.h")
        {.number = "04",
         .folder = "04_accel",
         .title = "KD-trees and hierarchies of boxes over the wavefront's triangles",
         .make = lab04::make_renderer,
         .memory = lab04::memory_use,
         .has_pool = true,
         .accels = lab04::accels},
#endif
    };
    return all;
}

const Lab& find_lab(const std::string& name) {
    std::string known;
    for (const Lab& lab : labs()) {
        if (name == lab.number || "0" + name == lab.number || name == lab.folder) return lab;
        known += fmt::format("\n  {}  {}", lab.folder, lab.title);
    }
    throw UsageError(fmt::format("there is no lab '{}'; the labs are{}", name, known));
}

} // namespace raylab::app
