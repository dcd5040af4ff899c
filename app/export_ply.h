// Triangles as a PLY file (Turk, The PLY Polygon File Format, 1994), for other renderers to read.
#pragma once

#include "common/geometry/shapes.h"

#include <array>
#include <string>
#include <vector>

namespace raylab::app {

// Triangles with or without normals and texture coordinates at their corners; world space.
struct PlyMesh {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals; // as many as positions, or none: flat
    std::vector<Vec2> uv;      // as many as normals; v up
    std::vector<std::array<int, 3>> faces;

    // Two triangles around the diagonal from corner 0 to corner 2, facing as the quad does.
    void add(const Quad& quad);
    // Its three corners alone: a flat face.
    void add(const Triangle& triangle);
    // Its corners with their shading normals, all turned to the side of the geometric one.
    void add(const Triangle& triangle, const TriangleCorners& corners);

    // The same faces seen from behind, each moved by `gap` (world units) against its normal. For
    // flat meshes in which no two faces with different normals share a vertex: add(Quad) and
    // add(Triangle) make such meshes.
    PlyMesh back(float gap) const;
};

// ASCII. Each number has enough digits that reading it gives the same float.
std::string encode_ply(const PlyMesh& mesh);

} // namespace raylab::app
