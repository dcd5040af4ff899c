// Typed access to the bytes of a glTF file, every access within bounds that were checked before.
// glTF 2.0 specification, sections 3.6 (Binary Data Storage) and 4.4 (GLB).
#pragma once

#include "common/scene/mesh.h"
#include "common/scene/node.h"
#include "common/scene/tinygltf.h"

#include <string_view>

namespace raylab {

// The JSON text within a GLB file. Throws SceneError unless its chunks fill the file exactly.
std::string_view json_chunk(std::string_view glb, const std::string& name);

// Throws SceneError unless each buffer view lies within its buffer, as the JSON declares it.
// Before the library runs, which does not check the views that images use.
void check_buffer_views(const Node& root);

// Throws SceneError if the file requires an extension that changes geometry or encoding. Those of
// materials change only the look.
void check_extensions(const Node& root);

// The file as the library reads it, images still encoded (Image::image, or their view).
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
    // Throws SceneError unless all elements lie within the accessor's view.
    GltfElements(const GltfFile& file, int accessor);

    int count() const { return count_; }
    int components() const { return components_; }
    bool is_unsigned_integer() const;

    // A normalised integer is mapped to [0, 1] or [-1, 1] (section 3.11).
    double operator()(int element, int component) const;
    DVec3 vec3(int element) const;
    Vec2 vec2(int element) const;

  private:
    const unsigned char* data_;
    std::size_t stride_;
    int count_, components_, component_type_;
    bool normalized_;
};

// The bytes of a buffer view (an embedded image).
std::string_view view_bytes(const GltfFile& file, int view);

} // namespace raylab
