// What colour a surface has at a place: constant, or looked up in an image.
#pragma once

#include "common/scene/features.h"
#include "common/scene/view.h"

namespace raylab {

// The texture at uv, which repeats outside [0, 1)^2: bilinear between texel centres, which lie at
// ((column + 1/2) / width, (row + 1/2) / height), row 0 at v = 0.
HD Vec3 lookup(const SceneView& scene, const Texture& texture, Vec2 uv) {
    const float x = (uv.x - floorf(uv.x)) * texture.width - 0.5f;
    const float y = (uv.y - floorf(uv.y)) * texture.height - 0.5f;
    const int column = int(floorf(x)), row = int(floorf(y));
    const float fx = x - column, fy = y - row;
    // column lies in [-1, width]: one wrap is enough.
    const auto texel = [&](int i, int j) {
        i = i < 0 ? i + texture.width : i >= texture.width ? i - texture.width : i;
        j = j < 0 ? j + texture.height : j >= texture.height ? j - texture.height : j;
        return scene.texels[texture.first + j * texture.width + i];
    };
    const Vec3 low = (1 - fx) * texel(column, row) + fx * texel(column + 1, row);
    const Vec3 high = (1 - fx) * texel(column, row + 1) + fx * texel(column + 1, row + 1);
    return (1 - fy) * low + fy * high;
}

// Material::reflectance, or its texture's value at uv.
template <Features F>
HD Vec3 reflectance_at(const SceneView& scene, const Material& material, Vec2 uv) {
    if constexpr (F & feature::texture) {
        if (material.texture >= 0) return lookup(scene, scene.textures[material.texture], uv);
    }
    return material.reflectance;
}

} // namespace raylab
