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

    // What is left of a triangle with these texture coordinates: itself, nothing, or pieces: halved
    // at most max_depth times, down to a texel, the smallest taken whole or not at all by the alpha
    // at their middle. Pieces are halves of halves, so they meet without gaps but for rounding.
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
