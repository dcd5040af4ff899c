// Textures of glTF materials.
#include "common/load/gltf_texture.h"

#include "common/load/gltf_data.h"
#include "common/trace/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace raylab {
namespace {

// Element `index` of a top-level array.
Node element(const Node& root, const std::string& array, const Node& index) {
    const auto list = root.find(array);
    const std::vector<Node> elements = list ? list->elements() : std::vector<Node>{};
    const int i = index.integer();
    if (i < 0 || i >= int(elements.size()))
        index.fail(fmt::format("{} {} does not exist; the file has {}", array, i, elements.size()));
    return elements[std::size_t(i)];
}

Wrap read_wrap(const Node& sampler, const std::string& key) {
    const auto wrap = sampler.find(key);
    switch (wrap ? wrap->integer() : 10497) {
    case 10497:
        return Wrap::repeat;
    case 33071:
        return Wrap::clamp;
    case 33648:
        return Wrap::mirror;
    default:
        wrap->fail_expected("10497 (repeat), 33071 (clamp to edge) or 33648 (mirrored repeat)");
    }
}

double component(const Node& pair, std::size_t i) {
    const std::vector<Node> numbers = pair.elements();
    if (numbers.size() != 2) pair.fail_expected("an array of 2 numbers");
    return numbers[i].number();
}

// offset + rotation * scale * uv. The rotation is counterclockwise as one sees it, and v points
// down: u' = cos u + sin v, v' = -sin u + cos v.
UvTransform read_transform(const Node& node) {
    const auto offset = node.find("offset"), turn = node.find("rotation"),
               scale = node.find("scale");
    const double angle = turn ? turn->number() : 0;
    const double c = std::cos(angle), s = std::sin(angle);
    const double su = scale ? component(*scale, 0) : 1, sv = scale ? component(*scale, 1) : 1;
    UvTransform transform;
    transform.a = {c * su, s * sv, -s * su, c * sv};
    if (offset) transform.b = {component(*offset, 0), component(*offset, 1)};
    return transform;
}

} // namespace

GltfTexture read_gltf_texture(const Node& root, const Node& holder, const std::string& key,
                              GltfLosses& losses) {
    GltfTexture result;
    const auto info = holder.find(key);
    if (!info) return result;
    const Node texture = element(root, "textures", info->at("index"));
    const auto source = texture.find("source");
    if (!source) // in an extension: another format
        texture.fail("the texture has no image in a format of glTF's core; export its images as "
                     "PNG or JPEG");
    element(root, "images", *source);
    result.image = source->integer();
    if (const auto set = info->find("texCoord")) result.uv_set = set->integer();
    if (const auto index = texture.find("sampler")) {
        const Node sampler = element(root, "samplers", *index);
        result.wrap_u = read_wrap(sampler, "wrapS");
        result.wrap_v = read_wrap(sampler, "wrapT");
        constexpr int nearest = 9728;
        if (const auto filter = sampler.find("magFilter"); filter && filter->integer() == nearest)
            losses.add("nearest-texel filters", "texture");
    }
    if (const auto extensions = info->find("extensions"))
        if (const auto transform = extensions->find("KHR_texture_transform")) {
            result.transform = read_transform(*transform);
            if (const auto set = transform->find("texCoord")) result.uv_set = set->integer();
        }
    return result;
}

std::string percent_decoded(const std::string& uri) {
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        int byte = 0;
        const char* digits = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            name += char(byte);
            i += 2;
        } else {
            name += uri[i];
        }
    }
    return name;
}

std::string read_gltf_image(const GltfFile& file, int index, const ReadNamedFile& read) {
    const Node image = file.json("images", index);
    if (const auto view = image.find("bufferView")) {
        if (view->integer() < 0 || view->integer() >= int(file.model.bufferViews.size()))
            view->fail(fmt::format("bufferView {} does not exist; the file has {}", view->integer(),
                                   file.model.bufferViews.size()));
        return std::string(view_bytes(file, view->integer()));
    }
    const Node uri = image.at("uri");
    const std::string text = uri.string();
    if (!text.starts_with("data:")) return read(percent_decoded(text));
    std::vector<unsigned char> bytes;
    std::string type;
    if (!tinygltf::DecodeDataURI(&bytes, type, text, 0, false))
        uri.fail("expected a data URI of an image in base64; export the file again");
    return std::string(bytes.begin(), bytes.end());
}

int TexturePoint::texel_at(Vec2 uv) const {
    const Vec2 at = texture.transform(uv);
    const auto index = [](Wrap wrap, float u, int size) {
        const float x = wrapped(wrap, u) * float(size);
        return x >= 0 ? int(std::min(x, float(size - 1))) : 0; // also where u is huge
    };
    return index(texture.wrap_v, at.y, picture.height) * picture.width +
           index(texture.wrap_u, at.x, picture.width);
}

int TexturePoint::parts_a_side(const std::array<Vec2, 3>& uv) const {
    constexpr int most = 16;
    float longest = 0; // in texels
    for (int i = 0; i < 3; ++i) {
        const Vec2 edge = texture.transform(uv[(i + 1) % 3]) - texture.transform(uv[i]);
        longest = std::max({longest, std::fabs(edge.x) * float(picture.width),
                            std::fabs(edge.y) * float(picture.height)});
    }
    return longest < most ? std::max(1, int(std::ceil(longest))) : most;
}

} // namespace raylab
