// A tree of boxes over the bounded shapes that are no triangles: spheres and quads.
//
// The loader has sorted them into groups of sixteen that lie together, and a group is a leaf.
#pragma once

#include "common/scene/scene.h"
#include "labs/04_accel/bvh/tree.h"

namespace raylab::lab04 {

// The tree as a walk sees it. Leaf number g is the g-th group of spheres, or, past these, of quads.
struct ShapeTreeView {
    BvhView boxes; // none: there are too few groups, or no tree is wanted
    Array<SphereGroup> sphere_groups;
    Array<QuadGroup> quad_groups;
};

// Up to so many groups, a ray tests all of them faster than it goes down a tree.
constexpr int few_groups = 8;

// Over all groups of spheres and quads; no node if there are few_groups or less.
BvhTree build_shape_tree(const Scene& scene);

} // namespace raylab::lab04
