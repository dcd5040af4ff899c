// The shapes as they lie in device memory: flat arrays of plain structs, in world space.
//
// The loader makes six quads of a box in a scene file, whose shared corners have equal bits, and
// applies transforms. So kernels test only four shapes: sphere, quad, plane, triangle.
#pragma once

#include "common/geometry/bounds.h"

namespace raylab {

// What every shape carries besides its geometry.
struct ShapeTags {
    int id;       // position in the scene's file order, meshes expanded; unique over all shapes
    int material; // index into SceneView::materials
    int light;    // index into SceneView::lights, or -1 if the shape does not emit
};

// A sphere, in double. Near the surface, a large center and a large radius nearly cancel, so
// rounding one of them to float would move the surface by ulps of the radius.
struct Sphere {
    DVec3 center;
    double radius; // > 0
    ShapeTags tags;
};

// A planar convex quadrilateral v[0] v[1] v[2] v[3] in order around its edge. make_quad() computes
// the other fields from the corners. Neighbours that share an edge have corners with equal bits
// there, so a closed room is watertight.
struct Quad {
    Vec3 v[4];
    Vec3 normal; // unit, along cross(v[1] - v[0], v[3] - v[0])
    ShapeTags tags;

    bool parallelogram; // v[2] is exactly v[1] + v[3] - v[0]
    float area;
    // In a parallelogram, p - v[0] = c0 (v[1] - v[0]) + c1 (v[3] - v[0]) with
    //   ci = across[i].(p - v[0]).
    DVec3 across[2];
    float steepness; // the length of the longer `across`
    // [0]: of the half v[0] v[1] v[2]; [1]: of the half v[0] v[2] v[3]; equal in a parallelogram.
    DVec3 half_normal[2];  // normal to the half, of length 2 area
    float conditioning[2]; // see normal_conditioning() in error.h
};

// The infinite plane { p : dot(normal, p - point) = 0 }: the ground of a scene, for which no giant
// sphere is needed.
struct Plane {
    Vec3 point;
    Vec3 normal; // unit
    ShapeTags tags;
};

// A triangle, of a mesh or by itself. Geometric normal: cross(v[1] - v[0], v[2] - v[0]), unit.
struct Triangle {
    Vec3 v[3];
    Vec3 normal;
    int corners; // index into SceneView::corners, or -1: flat shading, no texture coordinates
    ShapeTags tags;
};

// Shading data at a triangle's three corners. Triangle itself has only what the intersection loop
// reads.
struct TriangleCorners {
    Vec3 normal[3];   // unit shading normals
    Vec2 uv[3];       // texture coordinates, v up
    int colours = -1; // index into SceneView::corner_colours, or -1: none
};

// Factors on the reflectance at the corners of a triangle whose mesh has vertex colours.
struct CornerColours {
    Vec3 factor[3]; // linear RGB, at least 0
};

// Up to 16 triangles that lie together in the array, with the box around them. Labs 01 to 03 skip a
// run whose box the ray misses; lab 04 has trees over triangles instead.
struct TriangleRun {
    Bounds bounds;
    int first, count;
};

} // namespace raylab
