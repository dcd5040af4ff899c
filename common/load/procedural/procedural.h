// Meshes made by a program, of any size: what shows how build and trace time grow with the number
// of triangles, each with one trait that is hard on an acceleration structure.
//
// The same arguments give the same bits on every machine and in every build: integers, sums,
// products, quotients and square roots alone, never fused (CMakeLists.txt), never a libm's sine.
#pragma once

#include "common/load/mesh.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace raylab {

constexpr int fewest_procedural_triangles = 100, most_procedural_triangles = 4000000;

struct ProceduralMesh {
    const char* name;  // in scene files and on command lines
    const char* trait; // what makes it hard for an acceleration structure
    bool is_closed;    // each edge is used as often in one direction as in the other
    // At most `triangles` of them and at least half as many, none without an area, every position
    // a float's value. y is up.
    Mesh (*make)(int triangles, std::uint32_t seed);
};

// All of them, sorted by name.
std::span<const ProceduralMesh> procedural_meshes();

// Nothing if there is none of that name.
const ProceduralMesh* find_procedural_mesh(const std::string& name);

std::vector<std::string> procedural_mesh_names();

// The generators, each in a file of its own; see there for shape and extent.
Mesh make_city(int triangles, std::uint32_t seed);
Mesh make_fractal(int triangles, std::uint32_t seed);
Mesh make_identical(int triangles, std::uint32_t seed);
Mesh make_needles(int triangles, std::uint32_t seed);
Mesh make_sphere_flake(int triangles, std::uint32_t seed);
Mesh make_stadium(int triangles, std::uint32_t seed);
Mesh make_terrain(int triangles, std::uint32_t seed);

} // namespace raylab
