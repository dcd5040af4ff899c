// Which structure over the triangles lab 04 builds, and how rays walk it. No field changes a bit of
// the image.
#pragma once

namespace raylab {

// automatic: what pays for the scene. none: every triangle is tested. kd: a KD-tree by the surface
// area heuristic. lbvh: boxes along the Morton curve, built by kernels. sah: boxes by the surface
// area heuristic. wide: eight boxes a node, compressed.
enum class AccelKind : int { automatic, none, kd, lbvh, sah, wide };
inline constexpr const char* accel_names[] = {"auto", "none", "kd", "lbvh", "sah", "wide"};

// How a walk gets back from a subtree: by a stack, by ropes, from the root again, by skip links, by
// parent pointers, by a trail of bits. automatic: the fastest that the structure has.
enum class WalkKind : int { automatic, stack, ropes, restart, skip, parent, trail };
inline constexpr const char* walk_names[] = {"auto", "stack",  "ropes", "restart",
                                             "skip", "parent", "trail"};

constexpr const char* name_of(AccelKind kind) { return accel_names[static_cast<int>(kind)]; }
constexpr const char* name_of(WalkKind kind) { return walk_names[static_cast<int>(kind)]; }

struct AccelSettings {
    AccelKind accel = AccelKind::automatic;
    WalkKind walk = WalkKind::automatic;

    friend bool operator==(const AccelSettings&, const AccelSettings&) = default;
};

} // namespace raylab
