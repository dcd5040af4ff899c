// The structure over a scene's triangles, and the tree over its spheres and quads: chosen, built,
// and kept in device memory.
#pragma once

#include "common/device/device_array.h"
#include "common/film/ledger.h"
#include "common/render/renderer.h"
#include "common/scene/scene.h"
#include "labs/04_accel/choose_accel.h"
#include "labs/04_accel/shapes/tree.h"
#include "labs/04_accel/structure.h"

namespace raylab::lab04 {

class Accel {
  public:
    // Builds what machine.accel asks for. Throws SettingsError if there is no such walk. A scene
    // without triangles has no structure and is not walked. Spheres and quads have a tree of their
    // own where there are many, whatever the triangles have; with --accel none they have none
    // either.
    Accel(const Scene& scene, const MachineSettings& machine);

    // triangles: the scene's, in device memory.
    StructureView view(Array<Triangle> triangles) const;

    // scene: in device memory.
    ShapeTreeView shapes(const SceneView& scene) const;

    bool has_triangles() const { return facts_.triangles > 0; }
    bool has_shape_tree() const { return shape_facts_.nodes > 0; }
    const WalkKernels& kernels() const { return choice_.walk.kernels; }
    const StructureFacts& facts() const { return facts_; }
    const ShapeTreeFacts& shape_facts() const { return shape_facts_; }
    std::uint64_t bytes() const { return facts_.bytes + shape_facts_.bytes; }

    // Other kernels for the same structure: for tests of what happens if a walk is wrong.
    void walk_with(const WalkKernels& kernels) { choice_.walk.kernels = kernels; }

  private:
    void build(const std::vector<Triangle>& triangles, const MachineSettings& machine);
    void build_shapes(const Scene& scene);

    AccelChoice choice_;
    StructureFacts facts_;
    ShapeTreeFacts shape_facts_;
    DeviceArray<BvhNode> shape_boxes_;
    DeviceArray<TrianglePack> packs_;
    DeviceArray<BvhNode> bvh_;
    DeviceArray<SkipNode> skip_;
    DeviceArray<WideNode> wide_;
    Vec3 wide_extent_{0};
    DeviceArray<KdNode> kd_;
    DeviceArray<std::int32_t> kd_leaf_of_;
    DeviceArray<KdLeaf> kd_leaves_;
    Bounds kd_bounds_;
};

} // namespace raylab::lab04
