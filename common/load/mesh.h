// A mesh as its file gives it, before the scene's transform: what the OBJ and glTF readers return.
#pragma once

#include "common/load/picture.h"
#include "common/material/material.h"
#include "common/scene/view.h"

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

struct MeshTriangle {
    std::array<int, 3> position;           // indices into Mesh::positions
    std::array<int, 3> normal{-1, -1, -1}; // into Mesh::normals, or all -1: none
    std::array<int, 3> uv{-1, -1, -1};     // into Mesh::uvs, or all -1: none
    std::array<int, 3> colour{-1, -1, -1}; // into Mesh::colours, or all -1: none
    int material = -1;                     // into Mesh::materials, or -1: none
};

// A mesh file's own material, or the nearest that raylab has.
struct MeshMaterial {
    std::string name;
    Material material; // without its texture
    int picture = -1;  // into Mesh::pictures, or -1; its texels are multiplied by reflectance
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat; // of the picture
    int source = -1; // equal for all materials made of one material of the file; -1: none other
};

// A point light of a mesh file.
struct MeshLight {
    DVec3 position;
    Vec3 intensity; // radiant intensity
};

// A perspective camera of a glTF file, in the file's frame.
struct MeshCamera {
    std::string name;
    DVec3 position, forward, up; // directions of any length above 0
    double vfov_deg = 45;
    double aspect = 0; // width over height; 0: not told
};

struct Mesh {
    std::vector<DVec3>
        positions; // may be non-finite: triangles that use such a one are dropped later
    std::vector<DVec3> normals;          // any length, also 0
    std::vector<Vec2> uvs;               // v up
    std::vector<Vec3> colours;           // factors on the reflectance, linear, in [0, 1]
    std::vector<MeshTriangle> triangles; // counterclockwise seen from outside
    std::vector<MeshMaterial> materials;
    std::vector<Picture> pictures;
    std::vector<MeshLight> lights;
    std::vector<MeshCamera> cameras;
    std::vector<std::string> warnings;
};

// Reads a file that a mesh file names, relative to it; throws SceneError.
using ReadNamedFile = std::function<std::string(const std::string& name)>;

// Wavefront OBJ. With `read`, the materials that `usemtl` names are read from its MTL files; what
// is missing there is warned of. Throws SceneError as `name:line: expected ..., found ...`.
Mesh parse_obj(std::string_view text, const std::string& name, const ReadNamedFile& read = {});

// Does the scene want the file's own materials, or only its geometry?
enum class MeshLook { own, none };

// glTF 2.0, as text or as one binary file (GLB). Throws SceneError.
Mesh parse_gltf(std::string_view bytes, const std::string& name, const ReadNamedFile& read,
                MeshLook look = MeshLook::own);

// By the ending of the file's name: .obj, .gltf or .glb. Throws SceneError, also for another one.
Mesh parse_mesh(std::string_view bytes, const std::string& name, const ReadNamedFile& read,
                MeshLook look);

// How a scene calls the materials of a mesh file, for each of Mesh::materials: by their names; a
// second Wood is "Wood 2", the fifth of all, if it has no name, "material 5".
std::vector<std::string> material_keys(const Mesh& mesh);

// Gives every triangle that has no normals one per corner: the mean of the faces' normals around
// the same position, weighted by their angles there, so that it does not depend on how polygons
// were cut (Thurmer and Wuthrich, Computing Vertex Normals from Polygonal Facets, JGT 3(1), 1998).
void compute_smooth_normals(Mesh& mesh);

} // namespace raylab
