// What can be said of a glTF file before its numbers are read.
#include "common/load/gltf_check.h"

#include "common/load/scene_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

namespace raylab {
namespace {

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (int i = 3; i >= 0; --i)
        value = value << 8 | static_cast<unsigned char>(bytes[at + std::size_t(i)]);
    return value;
}

std::string convert_from(const std::string& version) {
    return "this is glTF " + version +
           ", and raylab reads glTF 2.0; import the file in Blender and export it as glTF 2.0, or "
           "convert it: gltf-pipeline -i old.gltf -o new.glb";
}

struct Version {
    int major = 0, minor = 0;
};

Version version_of(const Node& node) {
    const std::string text = node.string();
    Version version;
    const char* end = text.data() + text.size();
    const auto [dot, error] = std::from_chars(text.data(), end, version.major);
    const bool has_dot = error == std::errc() && dot != end && *dot == '.';
    if (!has_dot || std::from_chars(dot + 1, end, version.minor).ptr != end || dot + 1 == end)
        node.fail_expected("a version such as \"2.0\"");
    return version;
}

// Whether some element of a top-level array has the property.
template <class Test> bool any_of(const Node& root, const std::string& array, Test&& test) {
    const auto elements = root.find(array);
    if (!elements) return false;
    const std::vector<Node> nodes = elements->elements();
    return std::any_of(nodes.begin(), nodes.end(), test);
}

bool has_extension(const Node& node, const std::string& name) {
    const auto extensions = node.find("extensions");
    return extensions && extensions->has(name);
}

// Whether some geometry exists only in Draco's data: a primitive whose accessors have no view.
bool has_draco_only(const Node& root) {
    return any_of(root, "meshes",
                  [](const Node& mesh) {
                      const std::vector<Node> primitives = mesh.at("primitives").elements();
                      return std::any_of(primitives.begin(), primitives.end(), [](const Node& p) {
                          return has_extension(p, "KHR_draco_mesh_compression");
                      });
                  }) &&
           any_of(root, "accessors", [](const Node& accessor) {
               return !accessor.has("bufferView") && !accessor.has("sparse");
           });
}

// Whether a buffer has no data of its own, and only has the size that meshopt's data would have
// when decompressed.
bool has_meshopt_only(const Node& root) {
    return any_of(root, "buffers", [](const Node& buffer) {
        return has_extension(buffer, "EXT_meshopt_compression") && !buffer.has("uri");
    });
}

[[noreturn]] void fail_as_draco(const Node& at) {
    at.fail(
        "the geometry is compressed by Draco (KHR_draco_mesh_compression), which raylab does not "
        "read; export the file without compression: in Blender, import it, and export it with "
        "\"Compression\" off");
}

[[noreturn]] void fail_as_meshopt(const Node& at) {
    at.fail("the geometry is compressed by meshoptimizer (EXT_meshopt_compression), which raylab "
            "does not read; export the file without compression, or undo it: gltfpack -i in.glb -o "
            "out.glb, without -c and -cc");
}

[[noreturn]] void fail_as_texture_format(const Node& at, const std::string& what) {
    at.fail("the textures are " + what +
            ", which raylab does not read; export them as PNG or JPEG");
}

} // namespace

std::string_view json_chunk(std::string_view glb, const std::string& name) {
    constexpr std::size_t header = 12, chunk_header = 8;
    constexpr std::uint32_t json_type = 0x4E4F534A;
    if (glb.size() < header + chunk_header || !glb.starts_with("glTF"))
        throw SceneError(
            name + ": expected a binary glTF file, which begins with \"glTF\"; export it again");
    if (little_endian(glb, 4) != 2)
        throw SceneError(name + ": " + convert_from(fmt::format("{}.0", little_endian(glb, 4))));
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

void check_version(const Node& root) {
    const Node asset = root.at("asset");
    // Files of glTF 1.0 name their parts by objects, not by arrays; their version may be a number
    // or left out.
    if (root.has("meshes") && !root.at("meshes").is_array()) asset.fail(convert_from("1.0"));
    const Node text = asset.at("version");
    if (version_of(text).major != 2) text.fail(convert_from(text.string()));
    if (const auto least = asset.find("minVersion")) {
        const Version version = version_of(*least);
        if (version.major != 2 || version.minor > 0)
            least->fail("the file asks for a reader of glTF " + least->string() +
                        ", and raylab reads 2.0; export it as glTF 2.0");
    }
}

void check_extensions(const Node& root) {
    static constexpr std::array known{"KHR_mesh_quantization", "KHR_texture_transform",
                                      "KHR_lights_punctual", "EXT_mesh_gpu_instancing"};
    if (const auto required = root.find("extensionsRequired"))
        for (const Node& extension : required->elements()) {
            const std::string name = extension.string();
            if (name == "KHR_draco_mesh_compression") fail_as_draco(extension);
            if (name == "EXT_meshopt_compression") fail_as_meshopt(extension);
            if (name == "KHR_texture_basisu")
                fail_as_texture_format(extension, "KTX2 files (KHR_texture_basisu)");
            if (name == "EXT_texture_webp")
                fail_as_texture_format(extension, "WebP files (EXT_texture_webp)");
            // What materials have beside the core changes only the look: see gltf_material.h.
            if (!name.starts_with("KHR_materials_") &&
                std::find(known.begin(), known.end(), name) == known.end())
                extension.fail("the extension " + quote(name) +
                               " is not supported; export the mesh without it");
        }
    if (const auto used = root.find("extensionsUsed"))
        for (const Node& extension : used->elements()) {
            const std::string name = extension.string();
            if (name == "KHR_draco_mesh_compression" && has_draco_only(root))
                fail_as_draco(extension);
            if (name == "EXT_meshopt_compression" && has_meshopt_only(root))
                fail_as_meshopt(extension);
        }
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

} // namespace raylab
