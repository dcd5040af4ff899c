// What the tests of the hierarchies of boxes share: triangles, the trees over them, and their
// walks.
#pragma once

#include "labs/04_accel/bvh/sah.h"
#include "labs/04_accel/bvh/skip_tree.h"
#include "labs/04_accel/bvh/walk_parent.h"
#include "labs/04_accel/bvh/walk_skip.h"
#include "labs/04_accel/bvh/walk_stack.h"
#include "labs/04_accel/bvh/walk_trail.h"
#include "labs/04_accel/tests/cases.h"
#include "labs/04_accel/wide/tree.h"
#include "labs/04_accel/wide/walk_stack.h"
#include "labs/04_accel/wide/walk_trail.h"

namespace raylab::lab04 {

enum class BoxWalk { stack, trail, parent, skip, wide_stack, wide_trail };
constexpr BoxWalk box_walks[] = {BoxWalk::stack, BoxWalk::trail,      BoxWalk::parent,
                                 BoxWalk::skip,  BoxWalk::wide_stack, BoxWalk::wide_trail};
constexpr bool is_wide(BoxWalk kind) { return kind >= BoxWalk::wide_stack; }

inline std::string name(BoxWalk kind) {
    switch (kind) {
    case BoxWalk::stack:
        return "the walk with a stack";
    case BoxWalk::trail:
        return "the walk with a trail";
    case BoxWalk::parent:
        return "the walk by parent pointers";
    case BoxWalk::skip:
        return "the walk by skip links";
    case BoxWalk::wide_stack:
        return "the wide walk with a stack";
    case BoxWalk::wide_trail:
        return "the wide walk with a trail";
    }
    return "";
}

// Triangles, a binary tree over them, and what is made of it: a line with skip links, a wide tree.
struct BvhCase {
    explicit BvhCase(const std::vector<Triangle>& t) : BvhCase(t, build_bvh_sah(t)) {
        wide = build_wide(tree);
    }
    // Of this tree, without a wide one.
    BvhCase(std::vector<Triangle> t, BvhTree binary)
        : triangles(std::move(t)), tree(std::move(binary)), line(lay_skip_links(tree)) {}

    template <class Query> void walk(BoxWalk kind, Query& query) const {
        const BvhView bvh{{tree.nodes.data(), int(tree.nodes.size())}};
        const WideView eight{{wide.nodes.data(), int(wide.nodes.size())}, wide.extent};
        switch (kind) {
        case BoxWalk::stack:
            return walk_bvh_stack(bvh, query);
        case BoxWalk::trail:
            return walk_bvh_trail(bvh, query);
        case BoxWalk::parent:
            return walk_bvh_parent(bvh, query);
        case BoxWalk::skip:
            return walk_bvh_skip({{line.data(), int(line.size())}}, query);
        case BoxWalk::wide_stack:
            return walk_wide_stack(eight, query);
        case BoxWalk::wide_trail:
            return walk_wide_trail(eight, query);
        }
    }

    const std::vector<TrianglePack>& packs(BoxWalk kind) const {
        return is_wide(kind) ? wide.packs : tree.packs;
    }

    Answer answer(BoxWalk kind, const Ray& ray) const {
        return answer_of(packs(kind), triangles, ray, [&](auto& query) { walk(kind, query); });
    }

    std::vector<Triangle> triangles;
    BvhTree tree;
    std::vector<SkipNode> line;
    WideTree wide;
};

inline std::string difference(const BvhCase& scene, BoxWalk kind, const std::vector<Ray>& rays) {
    return difference(brute_force(scene.triangles, rays), name(kind), rays,
                      [&](const Ray& ray) { return scene.answer(kind, ray); });
}

} // namespace raylab::lab04
