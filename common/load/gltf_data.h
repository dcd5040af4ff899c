// Typed access to the bytes of a glTF file, every access within bounds that were checked before.
// glTF 2.0 specification, section 3.6 (Binary Data Storage).
#pragma once

#include "common/load/mesh.h"
#include "common/load/node.h"
#include "common/load/tinygltf.h"

#include <memory>
#include <string_view>
#include <vector>

namespace raylab {

// Buffers, views, accessors, meshes and nodes as the library reads them. It is not shown the rest,
// which raylab reads from the JSON itself (materials, images, skins), where errors have a place.
tinygltf::Model load_model(std::string_view bytes, bool binary, const std::string& name,
                           const ReadNamedFile& read);

// A file as the library read it, with its JSON, which knows where things stand.
struct GltfFile {
    const tinygltf::Model& model;
    const Node& root;

    // The JSON of element `index` of a top-level array ("accessors"), for errors.
    Node json(const std::string& array, int index) const;
};

// What one accessor reads: `count` elements of `components` numbers.
class GltfElements {
  public:
    // Sparse or not. Throws SceneError unless all elements lie within the accessor's view.
    GltfElements(const GltfFile& file, int accessor);

    // Throws SceneError at the accessor for a number that is not finite in a `what` ("normal").
    void expect_finite(const GltfFile& file, const std::string& what) const;

    int count() const { return count_; }
    int components() const { return components_; }
    bool is_unsigned_integer() const;

    // A normalised integer is mapped to [0, 1] or [-1, 1] (section 3.11).
    double operator()(int element, int component) const;
    DVec3 vec3(int element) const;
    Vec2 vec2(int element) const;
    glm::dmat4 mat4(int element) const;

  private:
    const unsigned char* bytes_of(const GltfFile& file, int view, std::size_t offset,
                                  std::size_t count, std::size_t size, std::size_t stride) const;

    int index_; // of the accessor
    const unsigned char* data_ = nullptr;
    std::size_t stride_ = 0;
    int count_ = 0, components_, component_type_;
    bool normalized_;
    std::shared_ptr<const std::vector<unsigned char>> own_; // of a sparse accessor
};

// The bytes of a buffer view (an embedded image).
std::string_view view_bytes(const GltfFile& file, int view);

} // namespace raylab
