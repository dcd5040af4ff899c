// A procedural shape: a mesh that a program makes (common/load/procedural), placed like any other.
#include "common/load/procedural/procedural.h"
#include "common/load/scene_builder.h"

#include <fmt/format.h>

namespace raylab {

void SceneBuilder::read_procedural(const Node& shape) {
    const Node name = shape.at("mesh"), count = shape.at("triangles");
    const ProceduralMesh& kind = *find_procedural_mesh(name.word(procedural_mesh_names()));
    const int triangles = count.integer();
    if (triangles < fewest_procedural_triangles || triangles > most_procedural_triangles)
        count.fail_expected(fmt::format("{} to {} triangles", fewest_procedural_triangles,
                                        most_procedural_triangles));
    const auto seed = shape.find("seed");
    material_named(shape.at("material")); // throws before the mesh is made
    Mesh mesh = kind.make(triangles, seed ? seed->seed() : 1);
    add_mesh(shape, name, mesh);
}

} // namespace raylab
