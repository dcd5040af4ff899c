// The shapes as they lie in device memory: flat arrays of plain structs, in world space.
//
// A box of a scene file becomes six quads that share their corners' bits, a transform is applied at
// load time. What a kernel tests is one of four: sphere, quad, plane, triangle.
#pragma once

#include "common/geometry/bounds.h"

namespace raylab {

// What every shape carries besides its geometry.
struct ShapeTags {
    int id;       // position in the scene's file order, meshes expanded; unique over all shapes
    int material; // index into SceneView::materials
    int light;    // index into SceneView::lights, or -1 if the shape does not emit
};

// In double. Near the surface, a large center and a large radius nearly cancel, so rounding one of
// them to float would move the surface by ulps of the radius.
struct Sphere {
    DVec3 center;
    double radius; // > 0
    ShapeTags tags;
};

// A planar convex quadrilateral v[0] v[1] v[2] v[3] in order around its edge; make_quad() fills in
// what follows from the corners. Neighbours that share an edge share its corners' bits, which makes
// a closed room watertight.
struct Quad {
    Vec3 v[4];
    Vec3 normal; // unit, that of cross(v[1] - v[0], v[3] - v[0])
    ShapeTags tags;

    bool parallelogram; // v[2] is opposite v[0] to the last bit
    float area;
    // Of a parallelogram: p - v[0] = c0 (v[1] - v[0]) + c1 (v[3] - v[0]) with ci = across[i].(p -
    // v[0]).
    DVec3 across[2];
    float steepness; // the length of the longer one
    // Of the half v[0] v[1] v[2] and the half v[0] v[2] v[3]; the same if it is a parallelogram.
    DVec3 half_normal[2];  // across its plane, twice the half's area long
    float conditioning[2]; // see normal_conditioning() in error.h
};

// The infinite plane { p : dot(normal, p - point) = 0 }: a ground, instead of a giant sphere.
struct Plane {
    Vec3 point;
    Vec3 normal; // unit
    ShapeTags tags;
};

// One triangle of a mesh, or a loose one. Geometric normal: cross(v[1] - v[0], v[2] - v[0]), unit.
struct Triangle {
    Vec3 v[3];
    Vec3 normal;
    int corners; // index into SceneView::corners, or -1: flat shading, no texture coordinates
    ShapeTags tags;
};

// Shading data at a triangle's three corners, apart from what the intersection loop reads.
struct TriangleCorners {
    Vec3 normal[3];   // unit shading normals
    Vec2 uv[3];       // texture coordinates, v up
    int colours = -1; // index into SceneView::corner_colours, or -1: none
};

// What a triangle's corners multiply the reflectance by, where its mesh has vertex colours.
struct CornerColours {
    Vec3 factor[3]; // linear RGB, at least 0
};

// Up to 16 triangles that lie together in the array, with the box around them: labs 01 to 03 skip a
// run whose box the ray misses; a hierarchy over them is lab 04.
struct TriangleRun {
    Bounds bounds;
    int first, count;
};

} // namespace raylab
