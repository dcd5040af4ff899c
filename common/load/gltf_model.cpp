// tinygltf at work: the arrays of numbers and the nodes, no images, no files but through the
// caller.
#include "common/load/gltf_check.h"
#include "common/load/gltf_data.h"
#include "common/load/scene_error.h"

#include <nlohmann/json.hpp>

namespace raylab {
namespace {

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

// tinygltf stops at the first thing that it does not expect, for instance a skin without joints,
// and its message does not say where. So it gets only the parts of the file for which raylab needs
// it.
std::string part_for_the_library(std::string_view json) {
    const nlohmann::json whole = nlohmann::json::parse(json);
    nlohmann::json part;
    for (const char* key :
         {"asset", "buffers", "bufferViews", "accessors", "meshes", "nodes", "scene", "scenes"})
        if (const auto found = whole.find(key); found != whole.end()) part[key] = *found;
    return part.dump();
}

void append_word(std::string& bytes, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += char(value >> shift & 255);
}

// The GLB file with another text in its JSON chunk.
std::string with_json(std::string_view glb, std::string_view old_json, std::string json) {
    while (json.size() % 4 != 0) json += ' ';
    const std::string_view rest = glb.substr(20 + old_json.size());
    std::string bytes = "glTF";
    append_word(bytes, 2);
    append_word(bytes, 20 + json.size() + rest.size());
    append_word(bytes, json.size());
    return bytes.append("JSON").append(json).append(rest);
}

} // namespace

tinygltf::Model load_model(std::string_view bytes, bool binary, const std::string& name,
                           const ReadNamedFile& read) {
    tinygltf::TinyGLTF library;
    library.SetFsCallbacks(reading_by(read));
    tinygltf::Model model;
    std::string error, warning;
    bool loaded = false;
    try {
        const std::string_view json = binary ? json_chunk(bytes, name) : bytes;
        const std::string part = part_for_the_library(json);
        if (binary) {
            const std::string glb = with_json(bytes, json, part);
            loaded = library.LoadBinaryFromMemory(
                &model, &error, &warning, reinterpret_cast<const unsigned char*>(glb.data()),
                unsigned(glb.size()));
        } else {
            loaded = library.LoadASCIIFromString(&model, &error, &warning, part.data(),
                                                 unsigned(part.size()), "");
        }
    } catch (const SceneError&) {
        throw;
    } catch (const std::exception& exception) {
        error = exception.what();
    }
    if (!loaded) {
        constexpr std::size_t most = 300; // the library quotes whole buffers
        if (error.size() > most) error = error.substr(0, most) + " ...";
        throw SceneError(name + ": not a valid glTF file: " + error);
    }
    return model;
}

} // namespace raylab
