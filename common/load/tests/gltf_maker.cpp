#include "common/load/tests/gltf_maker.h"

#include <fmt/format.h>

#include <cstdint>

namespace raylab {

std::string base64(const std::string& bytes) {
    const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word =
                word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? digits[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

int GltfMaker::view(const std::string& bytes) {
    views_ += fmt::format(R"({}{{"buffer":0,"byteOffset":{},"byteLength":{}}})",
                          views_.empty() ? "" : ",", data_.size(), bytes.size());
    data_ += bytes;
    while (data_.size() % 4 != 0) data_ += '\0';
    return view_count_++;
}

int GltfMaker::accessor(const std::string& type, int component_type, int count,
                        const std::string& bytes, const std::string& more) {
    accessors += fmt::format(R"({}{{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})",
                             accessors.empty() ? "" : ",", view(bytes), component_type, count, type,
                             more.empty() ? "" : "," + more);
    return accessor_count_++;
}

int GltfMaker::floats(const std::string& type, std::initializer_list<float> values) {
    const int components = type == "SCALAR" ? 1 : type == "MAT4" ? 16 : type.back() - '0';
    return accessor(type, 5126, int(values.size()) / components, little_endian(values));
}

std::string GltfMaker::gltf(const std::string& rest) const {
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{},"uri":"data:application/octet-stream;base64,{}"}}],"bufferViews":[{}],"accessors":[{}],{}}})",
        data_.size(), base64(data_), views_, accessors, rest);
}

GltfMaker one_triangle() {
    GltfMaker maker;
    maker.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
    maker.floats("VEC2", {0, 0, 1, 0, 0, 1});
    return maker;
}

std::string triangle_file(const GltfMaker& maker, const std::string& attributes,
                          const std::string& material, const std::string& rest) {
    return maker.gltf(fmt::format(
        R"("nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"TEXCOORD_0":1{}}},"material":0}}]}}],"materials":[{{{}}}]{})",
        attributes, material, rest.empty() ? "" : "," + rest));
}

Mesh parse_made(const std::string& bytes) {
    return parse_gltf(bytes, "m.gltf", [](const std::string& name) -> std::string {
        throw SceneError("there is no file " + name);
    });
}

Scene load_made(const std::string& bytes, const std::string& keys) {
    TemporaryFolder folder;
    folder.write("m.gltf", bytes);
    return load(scene_of_shapes(R"({"kind": "mesh", "file": "m.gltf")" + keys + "}"), folder);
}

DVec3 corner(const Mesh& mesh, int triangle, int i) {
    return mesh.positions.at(mesh.triangles.at(triangle).position[i]);
}

} // namespace raylab
