// Where glTF keeps its numbers: buffers, views of them, accessors of views.
#include "common/load/gltf_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace raylab {
namespace {

// The most elements of an accessor that has no view: a file of a few bytes must not make raylab
// allocate much memory.
constexpr std::size_t max_zeros = std::size_t(1) << 18;

template <class T> double load(const unsigned char* from, bool normalized) {
    T value;
    std::memcpy(&value, from, sizeof value); // may not be aligned
    if (!normalized || std::is_floating_point_v<T>) return double(value);
    return std::max(double(value) / double(std::numeric_limits<T>::max()), -1.0);
}

} // namespace

Node GltfFile::json(const std::string& array, int index) const {
    return root.at(array).elements().at(std::size_t(index));
}

// The bytes from `offset` of a view on, `count` elements of `size` bytes, `stride` apart.
const unsigned char* GltfElements::bytes_of(const GltfFile& file, int view_index,
                                            std::size_t offset, std::size_t count, std::size_t size,
                                            std::size_t stride) const {
    const tinygltf::Model& model = file.model;
    const auto fail = [&](const std::string& what) { file.json("accessors", index_).fail(what); };
    if (view_index < 0 || std::size_t(view_index) >= model.bufferViews.size())
        fail(fmt::format("bufferView {} does not exist; the file has {}", view_index,
                         model.bufferViews.size()));
    // The last element must end within the view, and the view within the buffer.
    const tinygltf::BufferView& view = model.bufferViews[view_index];
    const std::vector<unsigned char>& bytes = model.buffers[view.buffer].data;
    const std::size_t length = view.byteOffset > bytes.size()
                                   ? 0
                                   : std::min(view.byteLength, bytes.size() - view.byteOffset);
    const bool fits = offset <= length && size <= length - offset && count >= 1 &&
                      count - 1 <= (length - offset - size) / stride;
    if (!fits)
        fail(fmt::format(
            "expected {} elements of {} bytes, {} apart from byte {} on, within the {} bytes of "
            "bufferView {}; the file is damaged, export it again",
            count, size, stride, offset, length, view_index));
    return bytes.data() + view.byteOffset + offset;
}

GltfElements::GltfElements(const GltfFile& file, int index) : index_(index) {
    const tinygltf::Model& model = file.model;
    const tinygltf::Accessor& accessor = model.accessors[index];
    const auto fail = [&](const std::string& what) { file.json("accessors", index).fail(what); };
    component_type_ = accessor.componentType;
    components_ = tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type));
    const int component_size = tinygltf::GetComponentSizeInBytes(std::uint32_t(component_type_));
    if (components_ <= 0 || component_size <= 0)
        fail("unknown type or componentType; export the file again");
    const std::size_t size = std::size_t(components_) * std::size_t(component_size);
    normalized_ = accessor.normalized;
    count_ = int(std::min<std::size_t>(accessor.count, std::numeric_limits<int>::max()));
    if (accessor.bufferView >= 0) {
        const bool known = std::size_t(accessor.bufferView) < model.bufferViews.size();
        const std::size_t stride = known ? model.bufferViews[accessor.bufferView].byteStride : 0;
        stride_ = stride > 0 ? stride : size;
        data_ =
            bytes_of(file, accessor.bufferView, accessor.byteOffset, accessor.count, size, stride_);
    }
    if (accessor.bufferView >= 0 && !accessor.sparse.isSparse) return;

    // Copies the elements: zeros, or those of the view. The elements that the sparse part lists
    // then replace theirs (section 3.6.2.3).
    if (accessor.bufferView < 0 && (accessor.count < 1 || accessor.count > max_zeros))
        fail(fmt::format("expected 1 to {} elements without a bufferView, found {}; export the "
                         "file without sparse accessors",
                         max_zeros, accessor.count));
    auto own = std::make_shared<std::vector<unsigned char>>(accessor.count * size);
    if (accessor.bufferView >= 0)
        for (std::size_t i = 0; i < accessor.count; ++i)
            std::memcpy(own->data() + i * size, data_ + i * stride_, size);
    if (accessor.sparse.isSparse) {
        const auto& [count, is_sparse, indices, values] = accessor.sparse;
        const int index_type = indices.componentType;
        const std::size_t index_size = index_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 1
                                       : index_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 2
                                       : index_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT   ? 4
                                                                                              : 0;
        if (count < 1 || indices.byteOffset < 0 || values.byteOffset < 0 || index_size == 0)
            fail("expected a sparse part with a count, and indices of an unsigned integer type");
        const unsigned char* at =
            bytes_of(file, indices.bufferView, std::size_t(indices.byteOffset), std::size_t(count),
                     index_size, index_size);
        const unsigned char* from =
            bytes_of(file, values.bufferView, std::size_t(values.byteOffset), std::size_t(count),
                     size, size);
        for (std::size_t i = 0; i < std::size_t(count); ++i) {
            std::uint32_t element = 0;
            std::memcpy(&element, at + i * index_size, index_size);
            if (element >= accessor.count)
                fail(fmt::format("the sparse index {} is {}, but the accessor has {} elements; the "
                                 "file is damaged, export it again",
                                 i, element, accessor.count));
            std::memcpy(own->data() + element * size, from + i * size, size);
        }
    }
    stride_ = size;
    data_ = own->data();
    own_ = std::move(own);
}

void GltfElements::expect_finite(const GltfFile& file, const std::string& what) const {
    if (component_type_ != TINYGLTF_COMPONENT_TYPE_FLOAT) return;
    for (int i = 0; i < count_; ++i)
        for (int c = 0; c < components_; ++c)
            if (const double value = (*this)(i, c); !std::isfinite(value))
                file.json("accessors", index_)
                    .fail(fmt::format("expected finite numbers, found {} in {} {}; the file is "
                                      "damaged, export it again",
                                      value, what, i));
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

glm::dmat4 GltfElements::mat4(int element) const { // column by column
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = (*this)(element, i);
    return matrix;
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
