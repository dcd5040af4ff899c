// One triangle over and over: what no plane and no order of centroids can part. A tree must stop
// by itself, and of all the equal hits the lowest id is the answer.
#include "common/load/procedural/parts.h"
#include "common/load/procedural/procedural.h"

namespace raylab {

// With the corners (0, 0, 0), (1, 0, 0) and (0, 1, 0); the seed has nothing to choose.
Mesh make_identical(int triangles, std::uint32_t) {
    Mesh mesh;
    add_position(mesh, DVec3(0, 0, 0));
    add_position(mesh, DVec3(1, 0, 0));
    add_position(mesh, DVec3(0, 1, 0));
    for (int i = 0; i < triangles; ++i) add_triangle(mesh, 0, 1, 2);
    return mesh;
}

} // namespace raylab
