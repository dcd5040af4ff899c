// Textures of glTF materials: which image, where on the surface, what lies outside of it.
// glTF 2.0, sections 3.8.3 and 3.8.4; the extension KHR_texture_transform.
#pragma once

#include "common/load/gltf_losses.h"
#include "common/load/mesh.h"
#include "common/load/node.h"

#include <array>

namespace raylab {

// uv -> A uv + b, glTF's v, which points down.
struct UvTransform {
    std::array<double, 4> a{1, 0, 0, 1}; // row by row
    std::array<double, 2> b{0, 0};

    Vec2 operator()(Vec2 uv) const {
        return Vec2(a[0] * uv.x + a[1] * uv.y + b[0], a[2] * uv.x + a[3] * uv.y + b[1]);
    }
};

struct GltfTexture {
    int image = -1; // index into the file's images, or -1: no texture
    int uv_set = 0; // n of TEXCOORD_n
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    UvTransform transform;

    bool exists() const { return image >= 0; }
};

// The texture at a key of a material ("baseColorTexture"), if it is there.
GltfTexture read_gltf_texture(const Node& root, const Node& holder, const std::string& key,
                              GltfLosses& losses);

// The bytes of an image, from a data URI, a view or a file.
struct GltfFile;
std::string read_gltf_image(const GltfFile& file, int image, const ReadNamedFile& read);

// A file's name within a URI: "a%20b.png" is "a b.png" (RFC 3986, 2.1).
std::string percent_decoded(const std::string& uri);

// A picture as a function on the surface, at glTF's uv; nearest texel.
struct TexturePoint {
    const Picture& picture;
    const GltfTexture& texture;

    int texel_at(Vec2 uv) const; // index into picture.texels
    // The mean of f(texel index) over a triangle: the middles of up to 256 equal parts, one for
    // each texel where there are fewer.
    template <class F> Vec3 mean(const std::array<Vec2, 3>& uv, F&& f) const;

    int parts_a_side(const std::array<Vec2, 3>& uv) const;
};

template <class F> Vec3 TexturePoint::mean(const std::array<Vec2, 3>& uv, F&& f) const {
    const int n = parts_a_side(uv);
    Vec3 sum(0);
    // Row by row: the parts that stand on their side, and those on their corner between them.
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n - i; ++j)
            for (int turned = 0; turned < (j + i + 1 < n ? 2 : 1); ++turned) {
                const float third = turned ? 2.0f / 3 : 1.0f / 3;
                const float b1 = (float(i) + third) / float(n), b2 = (float(j) + third) / float(n);
                sum += f(texel_at((1 - b1 - b2) * uv[0] + b1 * uv[1] + b2 * uv[2]));
            }
    return sum / float(n * n);
}

} // namespace raylab
