// What the tests of the KD-tree share: triangles and a tree over them, and its three walks.
#pragma once

#include "labs/04_accel/kd/build.h"
#include "labs/04_accel/kd/ropes.h"
#include "labs/04_accel/kd/walk_restart.h"
#include "labs/04_accel/kd/walk_ropes.h"
#include "labs/04_accel/kd/walk_stack.h"
#include "labs/04_accel/tests/cases.h"

namespace raylab::lab04 {

enum class KdWalk { stack, ropes, restart };
constexpr KdWalk kd_walks[] = {KdWalk::stack, KdWalk::ropes, KdWalk::restart};

template <class Query> void walk(KdWalk kind, const KdView& tree, Query& query) {
    switch (kind) {
    case KdWalk::stack:
        return walk_kd_stack(tree, query);
    case KdWalk::ropes:
        return walk_kd_ropes(tree, query);
    case KdWalk::restart:
        return walk_kd_restart(tree, query);
    }
}

// Cuts cost next to nothing, so cells are cut as long as it is allowed: for tests that want many
// planes.
inline KdBuildSettings deep() {
    return {.costs = {.step = 0.05, .empty_factor = 0.9}, .copies = 20};
}

// Triangles and a tree over them.
struct KdCase {
    explicit KdCase(std::vector<Triangle> t, const KdBuildSettings& settings = {})
        : triangles(std::move(t)) {
        tree = build_kd_tree(triangles, settings);
        lay_ropes(tree);
    }

    Answer answer(KdWalk kind, const Ray& ray) const {
        return answer_of(tree.packs, triangles, ray,
                         [&](auto& query) { walk(kind, tree.view(), query); });
    }

    std::vector<Triangle> triangles;
    KdTree tree;
};

inline std::string name(KdWalk kind) {
    return kind == KdWalk::stack   ? "the walk with a stack"
           : kind == KdWalk::ropes ? "the walk along ropes"
                                   : "the walk that restarts";
}

inline std::string difference(const KdCase& scene, KdWalk kind, const std::vector<Ray>& rays) {
    return difference(brute_force(scene.triangles, rays), name(kind), rays,
                      [&](const Ray& ray) { return scene.answer(kind, ray); });
}

// How deep the deepest leaf lies; the root is at 0.
inline int depth(const KdTree& tree, int at = 0) {
    if (tree.nodes.empty() || tree.nodes[at].is_leaf()) return 0;
    return 1 + std::max(depth(tree, tree.nodes[at].below()), depth(tree, tree.nodes[at].above()));
}

} // namespace raylab::lab04
