// The loader has sorted the groups by halves of halves (common/scene/halving.h). This order is a
// tree already, and only its boxes are computed here.
#include "labs/04_accel/shapes/tree.h"

#include "common/scene/shape_boxes.h"

#include <algorithm>

namespace raylab::lab04 {
namespace {

template <class Shape, class Group>
void append_boxes(const std::vector<Shape>& shapes, const std::vector<Group>& groups,
                  std::vector<Bounds>& boxes) {
    for (const Group& group : groups) {
        Bounds& box = boxes.emplace_back();
        for (int i = 0; i < group.count; ++i) box.include(box_around(shapes[group.first + i]));
    }
}

// The axis along which the centres lie farthest apart, and whether a is the lower one there.
std::pair<int, bool> lie_apart(const Bounds& a, const Bounds& b) {
    const Vec3 from_a_to_b = b.low / 2.0f + b.high / 2.0f - a.low / 2.0f - a.high / 2.0f;
    const Vec3 far = abs(from_a_to_b);
    const int axis = far.x >= far.y ? (far.x >= far.z ? 0 : 2) : (far.y >= far.z ? 1 : 2);
    return {axis, from_a_to_b[axis] >= 0};
}

struct Builder {
    const std::vector<Bounds>& boxes; // of all groups
    int spheres;                      // groups of them, which come first
    BvhTree tree = {};

    struct Child {
        int child; // as in BvhNode
        Bounds box;
    };

    // Over the groups begin ... end - 1.
    Child build(int begin, int end, int parent, int level) {
        tree.depth = std::max(tree.depth, level);
        if (end - begin == 1) return {~begin, boxes[begin]};
        const int self = static_cast<int>(tree.nodes.size());
        tree.nodes.push_back({{}, {no_child, no_child}, parent, 0});
        const bool both = begin < spheres && spheres < end;
        const int middle = both ? spheres : begin + (end - begin) / 2;
        const Child first = build(begin, middle, self, level + 1),
                    second = build(middle, end, self, level + 1);
        const auto [axis, in_order] = lie_apart(first.box, second.box);
        BvhNode& node = tree.nodes[self];
        node.axis = axis;
        set_child(node, in_order ? 0 : 1, first.child, first.box);
        set_child(node, in_order ? 1 : 0, second.child, second.box);
        Bounds box = first.box;
        box.include(second.box);
        return {self, box};
    }
};

} // namespace

BvhTree build_shape_tree(const Scene& scene) {
    std::vector<Bounds> boxes;
    append_boxes(scene.spheres, scene.sphere_groups, boxes);
    append_boxes(scene.quads, scene.quad_groups, boxes);
    const int groups = static_cast<int>(boxes.size());
    if (groups <= few_groups) return {};
    Builder builder{boxes, static_cast<int>(scene.sphere_groups.size())};
    builder.build(0, groups, -1, 0);
    return std::move(builder.tree);
}

} // namespace raylab::lab04
