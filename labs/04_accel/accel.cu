// Building is the host's work, apart from kernels that builders launch; what is built is copied.
#include "labs/04_accel/accel.h"

#include "labs/04_accel/bvh/sah.h"
#include "labs/04_accel/kd/build.h"
#include "labs/04_accel/kd/ropes.h"
#include "labs/04_accel/lbvh/build.h"
#include "labs/04_accel/leaf/packs.h"
#include "labs/04_accel/wide/tree.h"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace raylab::lab04 {

namespace {

// Times building alone.
class Stopwatch {
  public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::vector<TrianglePack> all_packs(const std::vector<Triangle>& triangles) {
    std::vector<int> indices(triangles.size());
    std::iota(indices.begin(), indices.end(), 0);
    std::vector<TrianglePack> packs;
    append_packs(triangles, indices, packs);
    return packs;
}

// Nodes from the root to the deepest leaf; children come behind their parents.
int depth_of(const KdTree& tree) {
    std::vector<int> depth(tree.nodes.size());
    int deepest = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        deepest = std::max(deepest, depth[i]);
        if (tree.nodes[i].is_leaf()) continue;
        depth[tree.nodes[i].below()] = depth[tree.nodes[i].above()] = depth[i] + 1;
    }
    return deepest;
}

template <class T> Array<T> array_of(const DeviceArray<T>& memory) {
    return {memory.data(), static_cast<int>(memory.size())};
}

} // namespace

Accel::Accel(const Scene& scene, const MachineSettings& machine)
    : choice_(choose_accel(static_cast<int>(scene.triangles.size()), machine.accel)) {
    facts_.triangles = static_cast<int>(scene.triangles.size());
    facts_.name = name_of(choice_.walk.accel);
    facts_.walk =
        choice_.walk.walk == WalkKind::automatic ? "all triangles" : name_of(choice_.walk.walk);
    facts_.why = choice_.why;
    if (has_triangles()) build(scene.triangles, machine.threads);
    if (machine.accel.accel != AccelKind::none) build_shapes(scene);
}

void Accel::build(const std::vector<Triangle>& triangles, int threads) {
    const Stopwatch watch;
    const auto built = [&](int depth) {
        facts_.build_seconds = watch.seconds();
        facts_.depth = depth;
    };
    switch (choice_.walk.accel) {
    case AccelKind::kd: {
        KdTree tree = build_kd_tree(triangles, {.threads = threads});
        if (choice_.walk.walk == WalkKind::ropes) lay_ropes(tree);
        built(depth_of(tree));
        keep(tree.nodes, kd_);
        facts_.bytes +=
            tree.leaves.size() * sizeof(KdLeaf) + tree.leaf_of.size() * sizeof(std::int32_t);
        kd_leaf_of_ = DeviceArray<std::int32_t>(tree.leaf_of);
        kd_leaves_ = DeviceArray<KdLeaf>(tree.leaves);
        kd_bounds_ = tree.bounds;
        return keep_packs(tree.packs);
    }
    case AccelKind::lbvh: {
        const DeviceArray<Triangle> on_device(triangles);
        check(cudaDeviceSynchronize(), "cudaDeviceSynchronize");
        const Stopwatch kernels;
        const DeviceBvh bvh = build_lbvh(array_of(on_device));
        check(cudaDeviceSynchronize(), "cudaDeviceSynchronize");
        facts_.build_seconds = kernels.seconds();
        return keep_tree(to_host(bvh));
    }
    case AccelKind::sah: {
        const BvhTree tree = build_bvh_sah(triangles, threads);
        built(tree.depth);
        return keep_tree(tree);
    }
    case AccelKind::wide: {
        const WideTree tree = build_wide(build_bvh_sah(triangles, threads));
        built(tree.levels);
        keep(tree.nodes, wide_);
        wide_extent_ = tree.extent;
        return keep_packs(tree.packs);
    }
    default: {
        const std::vector<TrianglePack> packs = all_packs(triangles);
        built(0);
        return keep_packs(packs);
    }
    }
}

// As the walk wants it.
void Accel::keep_tree(const BvhTree& tree) {
    facts_.depth = tree.depth;
    if (choice_.walk.walk == WalkKind::skip)
        keep(lay_skip_links(tree), skip_);
    else
        keep(tree.nodes, bvh_);
    keep_packs(tree.packs);
}

template <class Node> void Accel::keep(const std::vector<Node>& nodes, DeviceArray<Node>& memory) {
    memory = DeviceArray<Node>(nodes);
    facts_.nodes = static_cast<int>(nodes.size());
    facts_.bytes += nodes.size() * sizeof(Node);
}

void Accel::keep_packs(const std::vector<TrianglePack>& packs) {
    packs_ = DeviceArray<TrianglePack>(packs);
    facts_.triangle_packs = static_cast<int>(packs.size());
    facts_.bytes += packs.size() * sizeof(TrianglePack);
}

void Accel::build_shapes(const Scene& scene) {
    const Stopwatch watch;
    const BvhTree tree = build_shape_tree(scene);
    shape_facts_ = {static_cast<int>(scene.spheres.size()),
                    static_cast<int>(scene.quads.size()),
                    static_cast<int>(tree.nodes.size()),
                    tree.depth,
                    tree.node_bytes(),
                    watch.seconds(),
                    {},
                    {}};
    shape_boxes_ = DeviceArray<BvhNode>(tree.nodes);
}

ShapeTreeView Accel::shapes(const SceneView& scene) const {
    return {{array_of(shape_boxes_)}, scene.sphere_groups, scene.quad_groups};
}

StructureView Accel::view(Array<Triangle> triangles) const {
    StructureView view;
    view.leaves = {array_of(packs_), triangles};
    view.bvh = {array_of(bvh_)};
    view.skip = {array_of(skip_)};
    view.wide = {array_of(wide_), wide_extent_};
    view.kd = {kd_bounds_, array_of(kd_), array_of(kd_leaf_of_), array_of(kd_leaves_),
               facts_.triangle_packs};
    return view;
}

} // namespace raylab::lab04
