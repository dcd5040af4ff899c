// The labs, as the program knows them: the one place where they meet. A tree that is handed out has
// one lab alone.
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
        {"01", "01_recursive", "the recursive tracer, plain C++", lab01::make_renderer,
         lab01::memory_use},
#endif
#if __has_include("labs/02_iterative/renderer.h")
        {"02", "02_iterative", "the iterative kernel, one CUDA thread a pixel",
         lab02::make_renderer, lab02::memory_use},
#endif
#if __has_include("labs/03_wavefront/renderer.h")
        {"03", "03_wavefront", "the wavefront: a pool of rays, one launch a stage and bounce",
         lab03::make_renderer, lab03::memory_use, true, true},
#endif
#if __has_include("labs/04_accel/renderer.h")
        {"04", "04_accel", "KD-trees and hierarchies of boxes over the wavefront's triangles",
         lab04::make_renderer, lab04::memory_use, true, false, lab04::accels},
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
