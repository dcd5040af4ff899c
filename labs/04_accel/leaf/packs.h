// Packs for the triangles of a leaf.
#pragma once

#include "common/geometry/shapes.h"
#include "labs/04_accel/leaf/triangle_pack.h"

#include <span>
#include <vector>

namespace raylab::lab04 {

// Appends as many packs as the triangles with these indices need; the last may have empty lanes.
inline void append_packs(const std::vector<Triangle>& triangles, std::span<const int> indices,
                         std::vector<TrianglePack>& packs) {
    for (std::size_t first = 0; first < indices.size(); first += triangles_per_pack) {
        TrianglePack& pack = packs.emplace_back();
        for (int lane = 0; lane < triangles_per_pack; ++lane) {
            const bool filled = first + lane < indices.size();
            pack.index[lane] = filled ? indices[first + lane] : -1;
            for (int corner = 0; corner < 3; ++corner)
                for (int axis = 0; axis < 3; ++axis)
                    pack.v[corner][axis][lane] =
                        filled ? triangles[indices[first + lane]].v[corner][axis] : 0.0f;
        }
    }
}

} // namespace raylab::lab04
