#include "common/load/procedural/procedural.h"

namespace raylab {
namespace {

constexpr ProceduralMesh all[] = {
    {"city", "boxes wall to wall: planes and edges that many triangles share, flat boxes", true,
     make_city},
    {"fractal", "a Sierpinski tetrahedron: most of every box is empty", true, make_fractal},
    {"identical", "one triangle over and over: no plane can part it from itself", false,
     make_identical},
    {"needles", "long thin triangles at a slant: boxes that overlap and hold next to nothing",
     false, make_needles},
    {"sphere_flake", "spheres on spheres on spheres: triangles of very different sizes", true,
     make_sphere_flake},
    {"stadium", "a small detailed thing in a huge coarse one: the teapot in a stadium", false,
     make_stadium},
    {"terrain", "a fractal height field: even triangles, the easy case", false, make_terrain},
};

} // namespace

std::span<const ProceduralMesh> procedural_meshes() { return all; }

const ProceduralMesh* find_procedural_mesh(const std::string& name) {
    for (const ProceduralMesh& mesh : all)
        if (name == mesh.name) return &mesh;
    return nullptr;
}

std::vector<std::string> procedural_mesh_names() {
    std::vector<std::string> names;
    for (const ProceduralMesh& mesh : all) names.push_back(mesh.name);
    return names;
}

} // namespace raylab
