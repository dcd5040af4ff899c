// Small glTF files, made in the test: numbers go into one buffer, the rest is JSON.
#pragma once

#include "common/load/mesh.h"
#include "common/load/tests/scene_files.h"

#include <initializer_list>
#include <string>
#include <vector>

namespace raylab {

class GltfMaker {
  public:
    // An accessor over these numbers ("VEC3"), its index returned.
    int floats(const std::string& type, std::initializer_list<float> values);
    // Of bytes as they are; `more` stands within the accessor ("\"normalized\":true").
    int accessor(const std::string& type, int component_type, int count, const std::string& bytes,
                 const std::string& more = "");
    int view(const std::string& bytes); // alone, for images and sparse parts

    // JSON of the file; `rest` are its other members ("\"nodes\":[...]").
    std::string gltf(const std::string& rest) const; // the buffer as a data URI
    std::string accessors;                           // as JSON, to be added to by hand

  private:
    std::string data_, views_;
    int view_count_ = 0, accessor_count_ = 0;
};

// The triangle (0,0,0) (1,0,0) (0,1,0) with texture coordinates (0,0) (1,0) (0,1), as accessors 0
// and 1 of a new file.
GltfMaker one_triangle();

// Its file, with more attributes (",\"COLOR_0\":2"), a material, and other members.
std::string triangle_file(const GltfMaker& maker, const std::string& attributes,
                          const std::string& material, const std::string& rest = "");

std::string base64(const std::string& bytes);

// Reads it; a file it names is an error.
Mesh parse_made(const std::string& bytes);

// As a mesh shape, with more keys (", \"lights\": true").
Scene load_made(const std::string& bytes, const std::string& keys = "");

DVec3 corner(const Mesh& mesh, int triangle, int i); // where it is

} // namespace raylab
