// What the readers of a scene file's sections share while a scene is being built.
#pragma once

#include "common/load/mesh.h"
#include "common/load/node.h"
#include "common/load/transform.h"
#include "common/scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace raylab {

// Sets the geometric normal; false if the triangle has no area or is not finite.
bool set_normal(Triangle& triangle);

// 64-bit FNV-1a (Fowler, Noll, Vo): h = (h xor byte) * prime.
class FileHash {
  public:
    void add(std::string_view bytes); // one file; its length counts too, so files cannot merge
    std::string hex() const;          // 16 digits

  private:
    std::uint64_t state_ = 0xCBF29CE484222325;
};

// The most triangles in a scene, meshes expanded: 1 GiB of them.
constexpr std::size_t max_triangles = std::size_t(1) << 24;

class SceneBuilder {
  public:
    SceneBuilder(const JsonDocument& document, const std::filesystem::path& where);
    Scene build();

  private:
    void read_camera(const Node& camera, const Node& film);
    void read_render(const Node& root, const Node& film);
    void read_materials(const Node& materials);
    void read_shapes(const Node& shapes);
    void read_lights(const Node& lights);
    void read_expect(const Node& expect);

    void read_sphere(const Node& shape, int material);
    void read_box(const Node& shape, int material);
    void read_quad(const Node& shape, int material);
    void read_plane(const Node& shape, int material);
    void read_triangle(const Node& shape, int material);
    void read_mesh(const Node& shape);
    void read_procedural(const Node& shape);

    void make_area_lights();
    void number_opaque_first();
    void read_environment(const Node& light);
    Transform read_transform(const Node& shape) const;
    Vec3 placed(const Node& shape, const Transform& transform,
                DVec3 p) const; // error if not finite
    void add_quad(const Node& shape, const Vec3 (&v)[4], int material);
    // `from`: the key that names the mesh, for messages.
    void add_mesh(const Node& shape, const Node& from, Mesh& mesh);
    std::vector<int> add_mesh_materials(const Node& shape, const Node& file, const Mesh& mesh);
    void add_mesh_lights(const Node& shape, const Mesh& mesh, const Transform& transform);

    Material read_material(const Node& node);
    int material_named(const Node& name);
    int add_material(const Material& material, const std::string& name);
    int texture_from_file(const Node& file);
    int add_texture(const Picture& picture, const Node& file, Vec3 factor = Vec3(1),
                    Wrap wrap_u = Wrap::repeat, Wrap wrap_v = Wrap::repeat);

    // The bytes of a file the scene names; part of the scene's hash.
    std::string read_named_file(const Node& file);

    const JsonDocument& document_;
    std::filesystem::path folder_;
    Scene scene_;
    FileHash hash_;
    std::map<std::string, int> material_index_;
    std::map<std::string, int> texture_index_; // by path
    std::vector<Triangle> loose_;              // triangles of no mesh, one group behind all meshes
    std::vector<Light> mesh_lights_;           // point lights of mesh files
    int left_out_ = 0;                         // loose triangles without area
    std::string first_left_out_;
    int next_id_ = 0;
};

} // namespace raylab
