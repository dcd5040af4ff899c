// The rays of a bench: what a path tracer asks, one kind at a time.
//
// From the hits of the camera's rays start a shadow ray, a ray of ambient occlusion and a diffuse
// bounce; from the hits of that bounce starts the second bounce. So all kinds but the first are
// spread over the mesh as light is. Figures in the literature are for these kinds (T. Aila, S.
// Laine, "Understanding the Efficiency of Ray Traversal on GPUs", HPG 2009).
#pragma once

#include "grader/bench/rays/ray_contestant.h"
#include "grader/bench/rays/ray_mesh.h"

#include <string>

namespace raylab::bench {

enum class RayKind : int {
    primary,  // through a random point of each pixel
    shadow,   // towards a random point of a lamp below the top of the bounds' middle; any hit
    ao,       // cosine-distributed, a fifth of the bounds' diagonal long; any hit
    diffuse1, // cosine-distributed
    diffuse2, // the same from where that one hits
};
constexpr RayKind all_ray_kinds[] = {RayKind::primary, RayKind::shadow, RayKind::ao,
                                     RayKind::diffuse1, RayKind::diffuse2};

const char* name_of(RayKind kind);
constexpr bool asks_any(RayKind kind) { return kind == RayKind::shadow || kind == RayKind::ao; }

struct RaySet {
    RayKind kind;
    std::vector<Ray> rays;
};

// All kinds, in their order. Random numbers are a function of the seed, the kind and the number of
// the ray before. Rays that leave a surface start on the ray that came to it, a thousandth of the
// way before the surface. Nothing is in the way there, whatever a contestant's offsets and
// tolerances are.
std::vector<RaySet> make_ray_sets(const RayMesh& mesh, const RayStructure& tracer,
                                  std::uint32_t seed);

} // namespace raylab::bench
