// Which descendants of a binary node become the children of a wide one? Those for which a ray pays
// least. Dynamic programming finds them, from the leaves up. Ylitie, Karras and Laine 2017,
// section 3.
#pragma once

#include "labs/04_accel/bvh/sah.h"
#include "labs/04_accel/wide/wide_bvh.h"

#include <array>

namespace raylab::lab04 {

struct WideChild {
    int child; // a node of the binary tree, or a leaf, as in BvhNode
    Bounds box;
};

class WidePlan {
  public:
    // tree: deep as build_bvh_sah() makes it at most; each node behind its parent.
    explicit WidePlan(const BvhTree& tree);

    // How children are chosen: by the plan; or evenly, so that three binary levels are one wide
    // level, where a chain of nodes might need more levels than there are.
    enum class Choice { planned, even };

    // For the wide node that stands for this binary node in this level.
    Choice choose(int node, int level) const;

    // Its children, at most eight, from near to far for rays of the octant: at each binary node the
    // lower child comes first, unless they go down the axis.
    std::vector<WideChild> children(int node, Choice choice, int octant) const;

  private:
    // The least cost[i] of a binary subtree that becomes at most i + 1 children of the wide node
    // above it: one node (i = 0), or a forest of several.
    struct Forest {
        std::array<double, wide_children - 1> cost;
        std::array<std::uint8_t, wide_children> from_left; // of i + 1 children, i = 7: of a node
        int height; // binary nodes from here to the deepest one
    };

    WideChild child_of(int node, int k) const;
    int height_of(const WideChild& c) const;
    double cost(const WideChild& c, int children) const;
    Forest plan(int node) const;
    void gather(const WideChild& c, int places, Choice choice, int octant,
                std::vector<WideChild>& found) const;
    void gather_both(int node, int places, Choice choice, int octant,
                     std::vector<WideChild>& found) const;

    const BvhTree& tree_;
    std::vector<Forest> forest_; // of each binary node
};

} // namespace raylab::lab04
