// Eight boxes a node, ten bits for each of their faces.
//
// A ray that visits a binary tree waits at every node: for the node's memory, then for the branch
// that depends on it. With eight children a node it waits a third as often. The low x faces of all
// eight boxes fit into one vector register, and so do those of the other five sides. A face is
// stored as a number of steps on a grid over the node. The step is a power of two. So a node takes
// 128 bytes, where plain floats would take 256. Ylitie, Karras and Laine, Efficient Incoherent Ray
// Traversal on GPUs Through Compressed Wide BVHs, HPG 2017.
#pragma once

#include "labs/04_accel/bvh/bvh.h"

#include <cstdint>
#include <cstring>

namespace raylab::lab04 {

constexpr int wide_children = 8;

struct WideNode {
    Vec3 origin;
    float step;         // face q of an axis lies at origin + q step; a power of two
    std::uint8_t inner; // a bit for each slot with a node,
    std::uint8_t leaf;  // and for each with a pack of triangles
    std::uint16_t unused;
    int first_child; // the nodes of the inner slots, one after the other
    int first_pack;  // the packs of the leaf slots
    int parent;      // -1: the root
    // The six faces of each slot's box, ten bits each, from the lowest bits up:
    std::uint32_t face[2][wide_children]; // low x, high x, low z; low y, high y, high z
    // For each octant of directions (a bit an axis, 1: d < 0) the slots from near to far, three
    // bits each, from the lowest bits up.
    std::uint32_t order[8];
};
static_assert(sizeof(WideNode) == 128, "the handout promises 128 bytes a node");

constexpr int face_bits = 10, last_face = (1 << face_bits) - 1;

HD_HOT std::int32_t bits_of(float value) { return __builtin_bit_cast(std::int32_t, value); }

HD_HOT float grid_face(std::uint32_t faces, int shift) {
    return static_cast<float>(static_cast<int>(faces >> shift & last_face));
}

// The face of a box: side 0 is low, 1 is high.
HD float grid_face(const WideNode& node, int slot, int axis, int side) {
    return axis == 2 ? grid_face(node.face[side][slot], 2 * face_bits)
                     : grid_face(node.face[axis][slot], side * face_bits);
}

struct WideView {
    Array<WideNode> nodes; // the root first; none: no triangle
    Vec3 extent;           // the largest |coordinate| on each axis
};

// The root is in level 0, its children in level 1 and so on. So many levels are enough for any tree
// (WidePlan::choose), and eight bits for each level are two machine words.
constexpr int max_wide_levels = 16;

HD int count_bits(std::uint32_t bits) {
#if defined(__CUDA_ARCH__)
    return __popc(bits);
#else
    return __builtin_popcount(bits);
#endif
}

HD std::uint32_t wide_slots(const WideNode& node) { return node.inner | node.leaf; }

// The node or pack in a slot: the first one of this node, plus how many are in the slots before.
HD_HOT int child_in(const WideNode& node, int slot) {
    return node.first_child + count_bits(node.inner & ((1u << slot) - 1));
}
HD_HOT int pack_in(const WideNode& node, int slot) {
    return node.first_pack + count_bits(node.leaf & ((1u << slot) - 1));
}

// The octant of directions in whose order a query wants to visit boxes.
template <class Query> HD_HOT int octant_of(const Query& query) {
    return query.first(0) | query.first(1) << 1 | query.first(2) << 2;
}

// A ray prepared for the boxes of nodes.
//
// A face at p = origin + q step lies at t = (p - o) / d. The walk computes it as
//     q (step / d) + (origin / d - o / d).
struct WideRay {
    Vec3 inv_d;
    Vec3 near_shift, far_shift; // o / d, and the room for rounding
    bool negative[3];
    Vec3 o;
    bool parallel[3]; // d = 0: the ray is always between the two faces, or never
    bool any_parallel;

    HD_HOT WideRay(const Ray& ray, Vec3 inverse, Vec3 extent) : o(ray.o) {
        const Vec3 size = abs(ray.o) + extent;
        any_parallel = false;
        float inv[3], near[3], far[3];
        for (int axis = 0; axis < 3; ++axis) {
            const float d = along(ray.d, axis), o = along(ray.o, axis);
            parallel[axis] = d == 0;
            any_parallel |= parallel[axis];
            // The ray is so slow on this axis that the axis is not used to bound t. Else the
            // products below might not be finite.
            const bool unbounded = fabsf(d) < 0x1p-40f;
            inv[axis] = unbounded ? 0.0f : along(inverse, axis);
            negative[axis] = inv[axis] < 0;
            // No number in t is larger than size / |d|, and each of its seven roundings is less
            // than u of that. So near faces are moved towards the ray's origin by this, far ones
            // away.
            const float room = 8 * unit_roundoff * along(size, axis) * fabsf(inv[axis]);
            near[axis] = o * inv[axis] + room;
            far[axis] = unbounded ? -infinity : o * inv[axis] - room;
        }
        inv_d = {inv[0], inv[1], inv[2]};
        near_shift = {near[0], near[1], near[2]};
        far_shift = {far[0], far[1], far[2]};
    }
};

// The slots between whose faces the ray is, on all axes along which it does not move.
HD std::uint32_t between_faces(const WideNode& node, const WideRay& ray) {
    std::uint32_t slots = 0xff;
    for (int axis = 0; axis < 3; ++axis) {
        if (!ray.parallel[axis]) continue;
        const double origin = node.origin[axis], o = ray.o[axis], step = node.step;
        for (int k = 0; k < wide_children; ++k)
            if (origin + grid_face(node, k, axis, 0) * step > o ||
                origin + grid_face(node, k, axis, 1) * step < o)
                slots &= ~(1u << k);
    }
    return slots;
}

// The first of the slots in this order; slots != 0. By branches instead of arithmetic: a processor
// predicts them and goes on with the slot that it expects, before the test of the boxes is
// finished.
HD_HOT int first_in_order(std::uint32_t slots, std::uint32_t order) {
    for (int k = 1; k < wide_children; ++k, order >>= 3)
        if (slots >> (order & 7) & 1) break;
    return order & 7;
}

// A bit for each slot whose box the ray crosses within [0, t_max]: maybe too many, never too few.
//
// Floats are compared by their bits, read as integers. Those that are not negative are in the same
// order as their bits. The bits of a negative float are a negative integer, and it counts as 0
// here. The larger of two integers takes one instruction of one cycle; the larger of two floats, of
// which one may be a NaN, takes two instructions of four cycles.
HD_HOT std::uint32_t crossed(const WideNode& node, const WideRay& ray, float t_max) {
    const Vec3 a = node.step * ray.inv_d;
    const Vec3 b_near = node.origin * ray.inv_d - ray.near_shift;
    const Vec3 b_far = node.origin * ray.inv_d - ray.far_shift;
    // On each axis the ray enters through one side and leaves through the other.
    const int enter_x = ray.negative[0] * face_bits, leave_x = face_bits - enter_x;
    const int enter_y = ray.negative[1] * face_bits, leave_y = face_bits - enter_y;
    const std::uint32_t* enter_z = node.face[ray.negative[2]];
    const std::uint32_t* leave_z = node.face[1 - ray.negative[2]];
    constexpr int z = 2 * face_bits;
    const std::int32_t last = bits_of(t_max);
    std::uint32_t slots = 0;
    const auto larger = [](std::int32_t i, std::int32_t j) { return i > j ? i : j; };
    const auto smaller = [](std::int32_t i, std::int32_t j) { return i < j ? i : j; };
    for (int k = 0; k < wide_children; ++k) {
        const std::uint32_t x = node.face[0][k], y = node.face[1][k];
        const std::int32_t near_x = bits_of(grid_face(x, enter_x) * a.x + b_near.x),
                           near_y = bits_of(grid_face(y, enter_y) * a.y + b_near.y),
                           near_z = bits_of(grid_face(enter_z[k], z) * a.z + b_near.z),
                           far_x = bits_of(grid_face(x, leave_x) * a.x + b_far.x),
                           far_y = bits_of(grid_face(y, leave_y) * a.y + b_far.y),
                           far_z = bits_of(grid_face(leave_z[k], z) * a.z + b_far.z);
        const std::int32_t near = larger(larger(near_x, near_y), larger(near_z, 0)),
                           far = smaller(smaller(far_x, far_y), smaller(far_z, last));
        slots |= std::uint32_t(near <= far) << k;
    }
    slots &= wide_slots(node);
    return ray.any_parallel ? slots & between_faces(node, ray) : slots;
}

} // namespace raylab::lab04
