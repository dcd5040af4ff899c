// Checks, before a render begins, whether there is enough memory for it.
#pragma once

#include "app/labs.h"
#include "common/cli/memory.h"

namespace raylab::app {

// The most memory that a render takes, besides the scene, which is loaded already: for each pixel
// the lab's film, the image that is made of the film, and the file that is made of the image.
struct MemoryNeed {
    int width, height;
    std::uint64_t pixel_bytes, fixed_bytes;

    std::uint64_t total() const {
        return fixed_bytes + pixel_bytes * static_cast<std::uint64_t>(width) * height;
    }
};

MemoryNeed memory_need(const Lab& lab, const Scene& scene, const MachineSettings& machine);

// "takes up to 3.31 GiB of memory, 104 bytes a pixel; 20.01 GiB are available"
std::string to_sentence(const MemoryNeed& need, const AvailableMemory& available);

// Throws UsageError, with these figures and the film that would fit, if the need cannot be met.
void check_memory(const MemoryNeed& need, const AvailableMemory& available);

} // namespace raylab::app
