// The colour of a surface at a point: a constant, or a value from an image.
#pragma once

#include "common/math/index.h"
#include "common/trace/surface.h"

namespace raylab {

// Maps any u to the coordinate in [0, 1] at which the image is read. With repeat and mirror, floats
// beyond 2^24 give 0, because they are even numbers; an infinite u gives 0, too, because inf - inf
// is NaN. A NaN always gives 0.
HD float wrapped(Wrap wrap, float u) {
    if (wrap == Wrap::repeat) return clamp(u - floorf(u), 0, 1);
    if (wrap == Wrap::clamp) return clamp(u, 0, 1);
    const float there_and_back = clamp(u - 2 * floorf(u / 2), 0, 2);
    return there_and_back <= 1 ? there_and_back : 2 - there_and_back;
}

// The texel for index i. i is in [-1, size], so at most one step leads back into the image. A
// mirrored image repeats the texel at its edge.
HD int wrapped(Wrap wrap, int i, int size) {
    if (wrap == Wrap::repeat) return i < 0 ? i + size : i >= size ? i - size : i;
    return i < 0 ? 0 : i >= size ? size - 1 : i;
}

// The texture at uv: bilinear between texel centres, which lie at
// ((column + 1/2) / width, (row + 1/2) / height), row 0 at v = 0.
HD Vec3 lookup(const SceneView& scene, const Texture& texture, Vec2 uv) {
    const float x = wrapped(texture.wrap_u, uv.x) * texture.width - 0.5f;
    const float y = wrapped(texture.wrap_v, uv.y) * texture.height - 0.5f;
    const int column = index_of(floorf(x) + 1, texture.width + 1) - 1; // in [-1, width - 1]
    const int row = index_of(floorf(y) + 1, texture.height + 1) - 1;
    const float fx = x - column, fy = y - row;
    const auto texel = [&](int i, int j) {
        i = wrapped(texture.wrap_u, i, texture.width);
        j = wrapped(texture.wrap_v, j, texture.height);
        return scene.texels[texture.first + j * texture.width + i];
    };
    const Vec3 low = (1 - fx) * texel(column, row) + fx * texel(column + 1, row);
    const Vec3 high = (1 - fx) * texel(column, row + 1) + fx * texel(column + 1, row + 1);
    return (1 - fy) * low + fy * high;
}

// The reflectance at a surface point: the value of the material's texture, or else
// Material::reflectance, times the vertex colour.
template <Features F>
HD Vec3 reflectance_at(const SceneView& scene, const Material& material,
                       const SurfacePoint& surface) {
    Vec3 reflectance = material.reflectance;
    if constexpr (F & feature::texture) {
        if (material.texture >= 0)
            reflectance = lookup(scene, scene.textures[material.texture], surface.uv);
    }
    if constexpr (F & feature::vertex_colours) reflectance *= surface.colour;
    return reflectance;
}

} // namespace raylab
