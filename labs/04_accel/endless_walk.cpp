#include "labs/04_accel/endless_walk.h"

#include "labs/04_accel/walks.h"

#include <fmt/format.h>

namespace raylab::lab04 {

namespace {

// The mistake that this walk invites.
std::string likely_cause(const StructureFacts& structure) {
    for (const KnownWalk& known : known_walks())
        if (known.accel == structure.name && known.walk == structure.walk)
            return known.when_endless;
    return "a loop that does not count up";
}

std::string text(Vec3 v) { return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z); }

} // namespace

EndlessWalk endless_walk(const EndlessRay& endless, int width, std::uint32_t sample,
                         const StructureFacts& structure) {
    const Ray& ray = endless.ray;
    return EndlessWalk(fmt::format(
        "a walk does not end: after {} nodes of the structure '{}' the walk '{}' was stopped. The "
        "ray: pixel ({}, {}), sample {}, origin {}, direction {}, t up to {:.9g}. Let it print the "
        "nodes that it visits for this ray: the first that comes twice shows the mistake. The "
        "likely cause: {}.",
        most_steps, structure.name, structure.walk, endless.pixel % width, endless.pixel / width,
        sample, text(ray.o), text(ray.d), ray.t_max, likely_cause(structure)));
}

} // namespace raylab::lab04
