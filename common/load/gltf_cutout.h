// Alpha cut-outs as geometry: a triangle is cut to the pieces where its texture's alpha is high
// enough, when the file is loaded. Kernels know no alpha, and no scene pays for it; every lab and
// every structure sees the same triangles.
#pragma once

#include "common/load/gltf_texture.h"
#include "common/load/picture.h"

#include <array>
#include <vector>

namespace raylab {

// A part of a triangle: its corners in barycentric coordinates of the whole, with its turn.
using Piece = std::array<Vec3, 3>;

constexpr Piece whole_triangle{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};

class Cutout {
  public:
    // A texel is there where alpha_factor * its alpha is at least cutoff. The picture must have
    // alpha, and outlive this.
    Cutout(const Picture& picture, const GltfTexture& texture, float alpha_factor, float cutoff);

    // What alpha leaves of a triangle with these texture coordinates: the triangle itself, nothing,
    // or pieces. Pieces are made by halving, at most max_depth times and not below a texel. The
    // smallest pieces are kept or removed as a whole, by the alpha at their middle. All pieces are
    // halves of halves, so they meet without gaps, except for rounding.
    std::vector<Piece> pieces(const std::array<Vec2, 3>& uv, int max_depth) const;

  private:
    enum class Part { none, some, all };
    struct Span {
        int first, last; // texels of the image, both included
    };

    void cut(const Piece& piece, const std::array<Vec2, 3>& uv, int halvings,
             std::vector<Piece>& result) const;
    Part part_in(const std::array<Vec2, 3>& uv) const;
    int there(Span columns, Span rows) const; // how many texels are there
    bool is_there(Vec2 uv) const;

    const Picture& picture_;
    const GltfTexture& texture_;
    float least_alpha_;
    std::vector<int> sums_; // (width + 1) x (height + 1): texels there above and to the left
};

} // namespace raylab
