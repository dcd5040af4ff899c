#include "labs/04_accel/endless_walk.h"

#include <fmt/format.h>

namespace raylab::lab04 {

namespace {

// The mistake that each walk invites.
std::string likely_cause(const std::string& walk) {
    if (walk == "stack") return "a node that is its own descendant, or that is pushed twice";
    if (walk == "ropes") return "a rope that leads back into the leaf it left, or a t that shrinks";
    if (walk == "restart")
        return "a ray's part that does not get shorter: a leaf must end behind where it begins";
    if (walk == "skip") return "a skip link that leads to its own node or back to one before it";
    if (walk == "parent")
        return "a way up that turns down again: coming from the second child, go on up";
    if (walk == "trail") return "a bit of the trail that is not cleared when its child was visited";
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
        sample, text(ray.o), text(ray.d), ray.t_max, likely_cause(structure.walk)));
}

} // namespace raylab::lab04
