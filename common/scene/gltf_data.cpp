// Where glTF keeps its numbers: buffers, views of them, accessors of views; and GLB's chunks.
#include "common/scene/gltf_data.h"

#include "common/scene/scene_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace raylab {
namespace {

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (int i = 3; i >= 0; --i)
        value = value << 8 | static_cast<unsigned char>(bytes[at + std::size_t(i)]);
    return value;
}

template <class T> double load(const unsigned char* from, bool normalized) {
    T value;
    std::memcpy(&value, from, sizeof value); // may not be aligned
    if (!normalized || std::is_floating_point_v<T>) return double(value);
    return std::max(double(value) / double(std::numeric_limits<T>::max()), -1.0);
}

} // namespace

std::string_view json_chunk(std::string_view glb, const std::string& name) {
    constexpr std::size_t header = 12, chunk_header = 8;
    constexpr std::uint32_t json_type = 0x4E4F534A;
    if (glb.size() < header + chunk_header || !glb.starts_with("glTF"))
        throw SceneError(
            name + ": expected a binary glTF file, which begins with \"glTF\"; export it again");
    if (little_endian(glb, 8) != glb.size())
        throw SceneError(
            fmt::format("{}: expected {} bytes, as the file's header says, found {}; the file "
                        "was cut off or damaged, copy it again",
                        name, little_endian(glb, 8), glb.size()));
    if (little_endian(glb, 16) != json_type)
        throw SceneError(name + ": expected a JSON chunk first; export it again");
    const std::size_t length = little_endian(glb, 12);
    for (std::size_t at = header; at < glb.size();) {
        const std::size_t left = glb.size() - at;
        if (left < chunk_header || left - chunk_header < little_endian(glb, at))
            throw SceneError(
                fmt::format("{}: the chunk at byte {} reaches beyond the end of the file; the "
                            "file is damaged, export it again",
                            name, at));
        at += chunk_header + little_endian(glb, at);
    }
    return glb.substr(header + chunk_header, length);
}

void check_buffer_views(const Node& root) {
    std::vector<int> lengths;
    if (const auto buffers = root.find("buffers"))
        for (const Node& buffer : buffers->elements()) {
            lengths.push_back(buffer.at("byteLength").integer());
            if (lengths.back() < 1) buffer.at("byteLength").fail_expected("at least 1 byte");
        }
    const auto views = root.find("bufferViews");
    if (!views) return;
    for (const Node& view : views->elements()) {
        const Node buffer = view.at("buffer"), length = view.at("byteLength");
        if (buffer.integer() < 0 || buffer.integer() >= int(lengths.size()))
            buffer.fail_expected(
                fmt::format("one of the file's {} buffers, counted from 0", lengths.size()));
        const int offset = view.has("byteOffset") ? view.at("byteOffset").integer() : 0;
        const int size = lengths[buffer.integer()];
        if (offset < 0 || length.integer() < 1 || offset > size || length.integer() > size - offset)
            length.fail(fmt::format(
                "expected bytes within buffer {}, which has {}, found {} bytes at {}; the "
                "file is damaged, export it again",
                buffer.integer(), size, length.integer(), offset));
    }
}

Node GltfFile::json(const std::string& array, int index) const {
    return root.at(array).elements().at(std::size_t(index));
}

GltfElements::GltfElements(const GltfFile& file, int index) {
    const tinygltf::Model& model = file.model;
    const tinygltf::Accessor& accessor = model.accessors[index];
    const auto fail = [&](const std::string& what) { file.json("accessors", index).fail(what); };
    if (accessor.sparse.isSparse || accessor.bufferView < 0)
        fail("expected a bufferView: sparse accessors are not supported; export without them");
    if (std::size_t(accessor.bufferView) >= model.bufferViews.size())
        fail(fmt::format("bufferView {} does not exist; the file has {}", accessor.bufferView,
                         model.bufferViews.size()));
    const tinygltf::BufferView& view = model.bufferViews[accessor.bufferView];
    const std::vector<unsigned char>& bytes = model.buffers[view.buffer].data;
    component_type_ = accessor.componentType;
    components_ = tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type));
    const int component_size = tinygltf::GetComponentSizeInBytes(std::uint32_t(component_type_));
    if (components_ <= 0 || component_size <= 0)
        fail("unknown type or componentType; export the file again");
    const std::size_t size = std::size_t(components_) * std::size_t(component_size);
    stride_ = view.byteStride > 0 ? view.byteStride : size;
    count_ = int(std::min<std::size_t>(accessor.count, std::numeric_limits<int>::max()));
    normalized_ = accessor.normalized;

    // The last element must end within the view, and the view within the buffer.
    const std::size_t length = view.byteOffset > bytes.size()
                                   ? 0
                                   : std::min(view.byteLength, bytes.size() - view.byteOffset);
    const bool fits = accessor.byteOffset <= length && size <= length - accessor.byteOffset &&
                      accessor.count >= 1 &&
                      accessor.count - 1 <= (length - accessor.byteOffset - size) / stride_;
    if (!fits)
        fail(fmt::format(
            "expected {} elements of {} bytes, {} apart from byte {} on, within the {} bytes of "
            "bufferView {}; the file is damaged, export it again",
            accessor.count, size, stride_, accessor.byteOffset, length, accessor.bufferView));
    data_ = bytes.data() + view.byteOffset + accessor.byteOffset;
}

bool GltfElements::is_unsigned_integer() const {
    return component_type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           component_type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           component_type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

double GltfElements::operator()(int element, int component) const {
    const std::size_t size =
        std::size_t(tinygltf::GetComponentSizeInBytes(std::uint32_t(component_type_)));
    const unsigned char* from =
        data_ + std::size_t(element) * stride_ + std::size_t(component) * size;
    switch (component_type_) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return load<std::int8_t>(from, normalized_);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return load<std::uint8_t>(from, normalized_);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return load<std::int16_t>(from, normalized_);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return load<std::uint16_t>(from, normalized_);
    case TINYGLTF_COMPONENT_TYPE_INT:
        return load<std::int32_t>(from, normalized_);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return load<std::uint32_t>(from, normalized_);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return load<float>(from, normalized_);
    default:
        return load<double>(from, normalized_);
    }
}

DVec3 GltfElements::vec3(int element) const {
    return DVec3((*this)(element, 0), (*this)(element, 1), (*this)(element, 2));
}

Vec2 GltfElements::vec2(int element) const {
    return Vec2((*this)(element, 0), (*this)(element, 1));
}

std::string_view view_bytes(const GltfFile& file, int index) {
    const tinygltf::BufferView& view = file.model.bufferViews[index];
    const std::vector<unsigned char>& bytes = file.model.buffers[view.buffer].data;
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
        file.json("bufferViews", index)
            .fail("reaches beyond the end of its buffer; export the file again");
    return {reinterpret_cast<const char*>(bytes.data()) + view.byteOffset, view.byteLength};
}

} // namespace raylab
