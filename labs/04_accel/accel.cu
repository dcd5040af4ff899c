// Building is the host's work, apart from kernels that builders launch; what is built is copied.
#include "labs/04_accel/accel.h"

#include <chrono>

namespace raylab::lab04 {

namespace {

template <class T> Array<T> array_of(const DeviceArray<T>& memory) {
    return {memory.data(), static_cast<int>(memory.size())};
}

} // namespace

Accel::Accel(const Scene& scene, const MachineSettings& machine)
    : choice_(choose_accel(static_cast<int>(scene.triangles.size()), machine.accel)) {
    const KnownWalk& walk = choice_.walk;
    facts_.triangles = static_cast<int>(scene.triangles.size());
    facts_.name = walk.accel;
    facts_.walk = walk.walk == "auto" ? walk.title : walk.walk;
    facts_.why = choice_.why;
    if (has_triangles()) build(scene.triangles, machine);
    if (machine.accel.accel != "none") build_shapes(scene);
}

void Accel::build(const std::vector<Triangle>& triangles, const MachineSettings& machine) {
    const KnownWalk& walk = choice_.walk;
    const Trees trees = build_trees(known_structure(walk.accel), walk.prepare, triangles, machine);
    facts_.nodes = trees.nodes();
    facts_.triangle_packs = static_cast<int>(trees.packs().size());
    facts_.depth = trees.depth();
    facts_.bytes = trees.bytes();
    facts_.build_seconds = trees.seconds;
    packs_ = DeviceArray<TrianglePack>(trees.packs());
    kd_ = DeviceArray<KdNode>(trees.kd.nodes);
    kd_leaf_of_ = DeviceArray<std::int32_t>(trees.kd.leaf_of);
    kd_leaves_ = DeviceArray<KdLeaf>(trees.kd.leaves);
    kd_bounds_ = trees.kd.bounds;
    bvh_ = DeviceArray<BvhNode>(trees.bvh.nodes);
    skip_ = DeviceArray<SkipNode>(trees.skip);
    wide_ = DeviceArray<WideNode>(trees.wide.nodes);
    wide_extent_ = trees.wide.extent;
}

void Accel::build_shapes(const Scene& scene) {
    const auto start = std::chrono::steady_clock::now();
    const BvhTree tree = build_shape_tree(scene);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    shape_facts_ = {static_cast<int>(scene.spheres.size()),
                    static_cast<int>(scene.quads.size()),
                    static_cast<int>(tree.nodes.size()),
                    tree.depth,
                    tree.node_bytes(),
                    took.count(),
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
