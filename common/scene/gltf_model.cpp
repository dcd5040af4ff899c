// tinygltf at work: no decoding of images, no files but through the caller.
#include "common/scene/gltf_data.h"
#include "common/scene/scene_error.h"

namespace raylab {
namespace {

// The library hands us an image's encoded bytes; we keep them, and decode those that are used.
bool keep_image(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
                const unsigned char* bytes, int size, void*) {
    if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
    return true;
}

tinygltf::FsCallbacks reading_by(const ReadNamedFile& read) {
    return {
        [](const std::string&, void*) { return true; },
        [](const std::string& name, void*) { return name; },
        [](std::vector<unsigned char>* bytes, std::string*, const std::string& name, void* user) {
            const std::string content = (*static_cast<const ReadNamedFile*>(user))(name);
            bytes->assign(content.begin(), content.end());
            return true;
        },
        nullptr, const_cast<ReadNamedFile*>(&read)};
}

} // namespace

void check_extensions(const Node& root) {
    const auto required = root.find("extensionsRequired");
    if (!required) return;
    for (const Node& extension : required->elements()) {
        const std::string name = extension.string();
        if (!name.starts_with("KHR_materials_") && name != "KHR_mesh_quantization")
            extension.fail("the extension " + quote(name) +
                           " is not supported; export the mesh without it");
    }
}

tinygltf::Model load_model(std::string_view bytes, bool binary, const std::string& name,
                           const ReadNamedFile& read) {
    tinygltf::TinyGLTF library;
    library.SetImageLoader(keep_image, nullptr);
    library.SetFsCallbacks(reading_by(read));
    tinygltf::Model model;
    std::string error, warning;
    bool loaded = false;
    try {
        if (binary) {
            const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
            loaded = library.LoadBinaryFromMemory(&model, &error, &warning, data,
                                                  unsigned(bytes.size()));
        } else {
            loaded = library.LoadASCIIFromString(&model, &error, &warning, bytes.data(),
                                                 unsigned(bytes.size()), "");
        }
    } catch (const SceneError&) {
        throw;
    } catch (const std::exception& exception) {
        error = exception.what();
    }
    if (!loaded) throw SceneError(name + ": not a valid glTF file: " + error);
    return model;
}

} // namespace raylab
