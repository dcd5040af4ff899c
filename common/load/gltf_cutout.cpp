// Alpha cut-outs as geometry.
#include "common/load/gltf_cutout.h"

#include "common/trace/texture.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace raylab {
namespace {

// The texels of an axis that bilinear lookups between u = low and high may touch: one or two spans.
std::vector<std::array<int, 2>> touched(Wrap wrap, float low, float high, int size) {
    const auto n = float(size);
    const std::vector<std::array<int, 2>> all{{0, size - 1}};
    if (wrap == Wrap::clamp) {
        low = clamp(low, 0, 1); // a NaN becomes 0, as where the texture is looked up
        high = clamp(high, 0, 1);
    } else {
        if (!(high - low < 1)) return all;
        const float period = std::floor(low);
        low -= period;
        high -= period; // low in [0, 1), high below 2
        const bool reversed = wrap == Wrap::mirror && std::fmod(period, 2.0f) != 0;
        if (wrap == Wrap::mirror) {
            if (high > 1) return all; // over a fold
            if (reversed) std::tie(low, high) = std::pair(1 - high, 1 - low);
        }
    }
    const int first = int(std::floor(low * n - 0.5f)), last = int(std::floor(high * n - 0.5f)) + 1;
    if (last - first + 1 >= size) return all;
    if (wrap != Wrap::repeat)
        return {{std::clamp(first, 0, size - 1), std::clamp(last, 0, size - 1)}};
    if (first < 0) return {{first + size, size - 1}, {0, last}};
    if (last >= size) return {{std::min(first, size - 1), size - 1}, {0, last - size}};
    return {{first, last}};
}

} // namespace

Cutout::Cutout(const Picture& picture, const GltfTexture& texture, float alpha_factor, float cutoff)
    : picture_(picture), texture_(texture), least_alpha_(cutoff / alpha_factor) {
    const int width = picture.width;
    sums_.assign(std::size_t(width + 1) * std::size_t(picture.height + 1), 0);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < width; ++x) {
            int* sum = &sums_[std::size_t(y + 1) * std::size_t(width + 1) + std::size_t(x + 1)];
            const bool is_there = picture.alpha[std::size_t(y * width + x)] >= least_alpha_;
            *sum = is_there + sum[-1] + sum[-width - 1] - sum[-width - 2];
        }
}

std::vector<Piece> Cutout::pieces(const std::array<Vec2, 3>& uv, int max_depth) const {
    std::vector<Piece> result;
    std::array<Vec2, 3> at;
    for (int i = 0; i < 3; ++i) at[i] = texture_.transform(uv[i]);
    cut(whole_triangle, at, max_depth, result);
    return result;
}

void Cutout::cut(const Piece& piece, const std::array<Vec2, 3>& uv, int halvings,
                 std::vector<Piece>& result) const {
    const Part part = part_in(uv);
    if (part == Part::none) return;
    if (part == Part::all) return result.push_back(piece);
    int longest = 0; // edge, from corner `longest` to the next, measured in texels
    float length = -1;
    for (int i = 0; i < 3; ++i) {
        const Vec2 edge = uv[(i + 1) % 3] - uv[i];
        const float texels =
            std::hypot(edge.x * float(picture_.width), edge.y * float(picture_.height));
        if (texels > length) longest = i, length = texels;
    }
    if (halvings == 0 || length <= 1) {
        if (is_there((uv[0] + uv[1] + uv[2]) / 3.0f)) result.push_back(piece);
        return;
    }
    const int a = longest, b = (longest + 1) % 3;
    Piece first = piece, second = piece;
    std::array<Vec2, 3> first_uv = uv, second_uv = uv;
    first[b] = second[a] = 0.5f * (piece[a] + piece[b]);
    first_uv[b] = second_uv[a] = 0.5f * (uv[a] + uv[b]);
    const std::size_t before = result.size();
    cut(first, first_uv, halvings - 1, result);
    const bool whole_first = result.size() == before + 1 && result.back() == first;
    cut(second, second_uv, halvings - 1, result);
    if (whole_first && result.size() == before + 2 && result.back() == second) {
        result.resize(before); // both halves are whole, so keep the undivided piece
        result.push_back(piece);
    }
}

Cutout::Part Cutout::part_in(const std::array<Vec2, 3>& uv) const {
    const auto [low_u, high_u] = std::minmax({uv[0].x, uv[1].x, uv[2].x});
    const auto [low_v, high_v] = std::minmax({uv[0].y, uv[1].y, uv[2].y});
    int present = 0, all = 0;
    for (const auto& columns : touched(texture_.wrap_u, low_u, high_u, picture_.width))
        for (const auto& rows : touched(texture_.wrap_v, low_v, high_v, picture_.height)) {
            present += there({columns[0], columns[1]}, {rows[0], rows[1]});
            all += (columns[1] - columns[0] + 1) * (rows[1] - rows[0] + 1);
        }
    return present == 0 ? Part::none : present == all ? Part::all : Part::some;
}

int Cutout::there(Span columns, Span rows) const {
    const auto sum = [&](int row, int column) {
        return sums_[std::size_t(row) * std::size_t(picture_.width + 1) + std::size_t(column)];
    };
    return sum(rows.last + 1, columns.last + 1) - sum(rows.first, columns.last + 1) -
           sum(rows.last + 1, columns.first) + sum(rows.first, columns.first);
}

// Bilinear, as the colour is.
bool Cutout::is_there(Vec2 uv) const {
    const float x = wrapped(texture_.wrap_u, uv.x) * float(picture_.width) - 0.5f;
    const float y = wrapped(texture_.wrap_v, uv.y) * float(picture_.height) - 0.5f;
    const int column = int(std::floor(x)), row = int(std::floor(y));
    const auto alpha = [&](int i, int j) {
        i = wrapped(texture_.wrap_u, i, picture_.width);
        j = wrapped(texture_.wrap_v, j, picture_.height);
        return picture_.alpha[std::size_t(j * picture_.width + i)];
    };
    const float fx = x - float(column), fy = y - float(row);
    const float high = (1 - fx) * alpha(column, row) + fx * alpha(column + 1, row);
    const float low = (1 - fx) * alpha(column, row + 1) + fx * alpha(column + 1, row + 1);
    return (1 - fy) * high + fy * low >= least_alpha_;
}

} // namespace raylab
