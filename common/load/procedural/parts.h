// What several procedural meshes are made of.
#pragma once

#include "common/load/mesh.h"

#include <cstdint>
#include <vector>

namespace raylab {

// Appends a position, rounded to single precision; its index.
int add_position(Mesh& mesh, DVec3 position);

void add_triangle(Mesh& mesh, int a, int b, int c);

// Which `count` of the numbers 0 .. n - 1 a seed chooses: n flags.
std::vector<bool> chosen(int count, int n, std::uint32_t seed);

// A sphere of 8 f^2 triangles: the octahedron's faces, cut into f^2 each, blown up.
void add_sphere(Mesh& mesh, DVec3 center, double radius, int f);

} // namespace raylab
