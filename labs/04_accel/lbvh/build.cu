// Codes, sorting, hierarchy, boxes: see build_lbvh() at the end.
#include "labs/04_accel/lbvh/build.h"

#include "common/device/launch.h"
#include "common/wavefront/grid.h"
#include "common/wavefront/scan_library.h"
#include "labs/04_accel/lbvh/host.h"
#include "labs/04_accel/lbvh/karras.h"
#include "labs/04_accel/lbvh/morton.h"
#include "labs/04_accel/lbvh/radix_sort.h"
#include "labs/04_accel/lbvh/refit.h"

#include <algorithm>
#include <chrono>

namespace raylab::lab04 {

namespace {

constexpr int block = 128;
constexpr int bounds_chunk = 1024;

// Greater than all codes, so triangles that are left out come last.
constexpr std::uint32_t no_code = 1u << 3 * morton_bits;

__device__ bool is_finite(const Triangle& triangle) {
    float sum = 0; // 0 * x is a NaN unless x is finite
    for (const Vec3& v : triangle.v) sum += 0 * v.x + 0 * v.y + 0 * v.z;
    return sum == 0;
}

__device__ Bounds bounds_of(const Triangle& triangle) {
    Bounds box;
    for (const Vec3& v : triangle.v) box.include(v);
    return box;
}

// Half of low + half of high: a sum might overflow.
__device__ Vec3 centre_of(const Bounds& box) { return 0.5f * box.low + 0.5f * box.high; }

// The box around the centres of a chunk of triangles, by one thread.
__global__ void centres_kernel(Array<Triangle> triangles, int chunks, Bounds* boxes) {
    const int c = static_cast<int>(global_index());
    if (c >= chunks) return;
    Bounds box;
    for (int i = c * bounds_chunk; i < triangles.size && i < (c + 1) * bounds_chunk; ++i)
        if (is_finite(triangles[i])) box.include(centre_of(bounds_of(triangles[i])));
    boxes[c] = box;
}

__global__ void codes_kernel(Array<Triangle> triangles, Bounds centres, std::uint32_t* codes,
                             int* indices) {
    const std::int64_t i = global_index();
    if (i >= triangles.size) return;
    const Triangle& triangle = triangles[i];
    codes[i] = is_finite(triangle) ? morton_code(centre_of(bounds_of(triangle)), centres) : no_code;
    indices[i] = static_cast<int>(i);
}

// The axis along which two halves of a range lie apart: that of the first bit that differs.
__device__ int split_axis(Array<std::uint32_t> codes, const KarrasNode& node) {
    const std::uint32_t differing = codes[node.split] ^ codes[node.split + 1];
    return differing == 0 ? 0 : (leading_zeros(differing) - (32 - 3 * morton_bits) + 3) % 3;
}

__device__ bool is_large(int first, int last) { return last - first >= triangles_per_pack; }

// One thread for each inner node of the tree over single triangles. Nodes over more triangles than
// a pack holds are kept: kept[i] = 1. A child of such a node that is no larger than a pack is a
// leaf: starts[i] = 1 where it begins. Both arrays are 0 before.
__global__ void cut_kernel(Array<std::uint32_t> codes, std::uint32_t* kept, std::uint32_t* starts) {
    const std::int64_t thread = global_index();
    if (thread >= codes.size - 1) return;
    const int i = static_cast<int>(thread);
    // Steps:
    // 1. Find the range of node i. One that fits into a pack is not kept.
    // 2. Else it is; each child that fits into a pack is a leaf, which begins at its first
    //    triangle.
    //[ task 4.5
    const KarrasNode node = karras_node(codes, i);
    if (!is_large(node.first, node.last)) return;
    kept[i] = 1;
    if (!is_large(node.first, node.split)) starts[node.first] = 1;
    if (!is_large(node.split + 1, node.last)) starts[node.split + 1] = 1;
    //| // Eight in a row are a leaf, and as many nodes as it takes are kept.
    //| not_implemented("4.5", "cut_kernel()");
    //| const int leaves = packs_for(codes.size);
    //| kept[i] = i < leaves - 1;
    //| starts[i] = i % triangles_per_pack == 0;
    //| if (i == codes.size - 2) starts[i + 1] = (i + 1) % triangles_per_pack == 0;
    //]
}

// Writes each node that is kept to the place of its new number: its children, and to each child the
// node as its parent.
__global__ void hierarchy_kernel(Array<std::uint32_t> codes, const std::uint32_t* kept,
                                 const std::uint32_t* node_numbers,
                                 const std::uint32_t* leaf_numbers, BvhNode* nodes,
                                 int* leaf_parents) {
    const std::int64_t thread = global_index();
    if (thread >= codes.size - 1 || !kept[thread]) return;
    const int i = static_cast<int>(thread), self = static_cast<int>(node_numbers[i]);
    // Steps:
    // 1. Find the range of node i.
    // 2. A child too large for a pack is an inner node: the left one has the number `split`, the
    //    right one the next. Look its new number up. Else it is the leaf that begins there:
    //    ~number.
    // 3. Set the node's axis.
    //[ task 4.5
    const KarrasNode node = karras_node(codes, i);
    const auto number = [&](int first, int last, int inner) {
        return is_large(first, last) ? static_cast<int>(node_numbers[inner])
                                     : ~static_cast<int>(leaf_numbers[first]);
    };
    const int left = number(node.first, node.split, node.split);
    const int right = number(node.split + 1, node.last, node.split + 1);
    nodes[self].axis = split_axis(codes, node);
    //| // Each node has the two numbers behind twice its own, as in a heap: a legal tree.
    //| not_implemented("4.5", "hierarchy_kernel()");
    //| const int inner = packs_for(codes.size) - 1;
    //| const int left = 2 * i + 1 < inner ? 2 * i + 1 : ~(2 * i + 1 - inner);
    //| const int right = 2 * i + 2 < inner ? 2 * i + 2 : ~(2 * i + 2 - inner);
    //]
    nodes[self].child[0] = left;
    nodes[self].child[1] = right;
    for (const int child : {left, right})
        (is_leaf(child) ? leaf_parents[~child] : nodes[child].parent) = self;
    if (i == 0) nodes[0].parent = -1;
}

// Fills the packs. A leaf is a range of at most eight triangles. starts[i]: a leaf begins at i, and
// numbers[i] is its number.
__global__ void leaves_kernel(Array<Triangle> triangles, const std::uint32_t* codes,
                              const int* indices, const std::uint32_t* starts,
                              const std::uint32_t* numbers, TrianglePack* packs) {
    const std::int64_t i = global_index();
    if (i >= triangles.size || !starts[i]) return;
    TrianglePack pack{};
    bool inside = true;
    for (int lane = 0; lane < triangles_per_pack; ++lane) {
        const std::int64_t at = i + lane;
        inside = inside && at < triangles.size && (lane == 0 || !starts[at]);
        const bool filled = inside && codes[at] != no_code;
        pack.index[lane] = filled ? indices[at] : -1;
        for (int corner = 0; filled && corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis)
                pack.v[corner][axis][lane] = triangles[indices[at]].v[corner][axis];
    }
    packs[numbers[i]] = pack;
}

Bounds bounds_of_centres(Array<Triangle> triangles) {
    const int chunks = parts_for(triangles.size, bounds_chunk);
    DeviceArray<Bounds> boxes(chunks);
    centres_kernel<<<blocks_for(chunks, block), block>>>(triangles, chunks, boxes.data());
    check(cudaGetLastError(), "centres_kernel");
    Bounds all;
    for (const Bounds& box : boxes.to_host()) all.include(box);
    return all;
}

// Numbers what is flagged: number[i] flags are set before i, and count in all.
struct Numbers {
    explicit Numbers(const DeviceArray<std::uint32_t>& flags) : number(flags.size()) {
        const std::int64_t n = static_cast<std::int64_t>(flags.size());
        DeviceArray<std::uint32_t> workspace(scan_library_workspace(n));
        scan_library(flags.data(), number.data(), n, workspace.data());
        std::uint32_t last[2] = {};
        check(cudaMemcpy(&last[0], flags.data() + n - 1, sizeof last[0], cudaMemcpyDeviceToHost),
              "the last flag");
        check(cudaMemcpy(&last[1], number.data() + n - 1, sizeof last[1], cudaMemcpyDeviceToHost),
              "the last number");
        count = static_cast<int>(last[0] + last[1]);
    }

    DeviceArray<std::uint32_t> number;
    int count;
};

DeviceBvh tree_of_one_leaf(Array<Triangle> triangles, const DeviceArray<std::uint32_t>& codes,
                           const DeviceArray<int>& indices) {
    const std::uint32_t begin = 1;
    DeviceArray<std::uint32_t> starts(triangles.size), numbers(triangles.size);
    check(cudaMemcpy(starts.data(), &begin, sizeof begin, cudaMemcpyHostToDevice), "the leaf");
    DeviceBvh bvh{DeviceArray<BvhNode>(1), DeviceArray<TrianglePack>(1)};
    leaves_kernel<<<1, block>>>(triangles, codes.data(), indices.data(), starts.data(),
                                numbers.data(), bvh.packs.data());
    check(cudaGetLastError(), "leaves_kernel");
    lone_leaf_kernel<<<1, 1>>>(bvh.packs.data(), bvh.nodes.data());
    check(cudaGetLastError(), "lone_leaf_kernel");
    return bvh;
}

} // namespace

DeviceBvh build_lbvh(Array<Triangle> triangles) {
    const int n = triangles.size;
    if (n == 0) return {};
    // 1. A place on the Morton curve for each triangle. 2. Sort by it.
    DeviceArray<std::uint32_t> codes(n);
    DeviceArray<int> indices(n);
    codes_kernel<<<blocks_for(n, block), block>>>(triangles, bounds_of_centres(triangles),
                                                  codes.data(), indices.data());
    check(cudaGetLastError(), "codes_kernel");
    radix_sort(codes, indices, 3 * morton_bits + 1);

    if (n <= triangles_per_pack) return tree_of_one_leaf(triangles, codes, indices);

    // 3. Which nodes there are, and where leaves begin; hence their numbers.
    const Array<std::uint32_t> sorted{codes.data(), n};
    const int blocks = blocks_for(n, block);
    DeviceArray<std::uint32_t> kept(n), starts(n);
    cut_kernel<<<blocks, block>>>(sorted, kept.data(), starts.data());
    check(cudaGetLastError(), "cut_kernel");
    const Numbers nodes(kept), leaves(starts);

    // 4. The nodes, all at once. 5. Their leaves. 6. Their boxes, from the leaves up.
    DeviceBvh bvh{DeviceArray<BvhNode>(nodes.count), DeviceArray<TrianglePack>(leaves.count)};
    DeviceArray<int> leaf_parents(leaves.count), arrived(nodes.count);
    hierarchy_kernel<<<blocks, block>>>(sorted, kept.data(), nodes.number.data(),
                                        leaves.number.data(), bvh.nodes.data(),
                                        leaf_parents.data());
    check(cudaGetLastError(), "hierarchy_kernel");
    leaves_kernel<<<blocks, block>>>(triangles, codes.data(), indices.data(), starts.data(),
                                     leaves.number.data(), bvh.packs.data());
    check(cudaGetLastError(), "leaves_kernel");
    refit_kernel<<<blocks_for(leaves.count, block), block>>>(
        bvh.packs.data(), leaves.count, leaf_parents.data(), bvh.nodes.data(), arrived.data());
    check(cudaGetLastError(), "refit_kernel");
    return bvh;
}

BvhTree to_host(const DeviceBvh& bvh) {
    BvhTree tree{bvh.nodes.to_host(), bvh.packs.to_host(), 0};
    for (const BvhNode& node : tree.nodes) {
        int depth = 1;
        for (int at = node.parent; at >= 0; at = tree.nodes[at].parent) ++depth;
        tree.depth = std::max(tree.depth, depth);
    }
    return tree;
}

BvhTree build_lbvh(const std::vector<Triangle>& triangles, const MachineSettings& machine,
                   double& seconds) {
    configure_machine(machine);
    const DeviceArray<Triangle> on_device(triangles);
    check(cudaDeviceSynchronize(), "cudaDeviceSynchronize");
    const auto start = std::chrono::steady_clock::now();
    const DeviceBvh bvh = build_lbvh({on_device.data(), static_cast<int>(triangles.size())});
    check(cudaDeviceSynchronize(), "cudaDeviceSynchronize");
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return to_host(bvh);
}

} // namespace raylab::lab04
