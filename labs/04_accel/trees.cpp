#include "labs/04_accel/trees.h"

#include "labs/04_accel/bvh/sah.h"
#include "labs/04_accel/kd/build.h"
#include "labs/04_accel/lbvh/host.h"
#include "labs/04_accel/leaf/packs.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <stdexcept>

namespace raylab::lab04 {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

template <class T> Array<T> array_of(const std::vector<T>& values) {
    return {values.data(), static_cast<int>(values.size())};
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

using Seconds = std::optional<double>;

Seconds build_wide_tree(Trees& trees, const std::vector<Triangle>& triangles,
                        const MachineSettings& machine) {
    trees.wide = build_wide(build_bvh_sah(triangles, machine.threads));
    return {};
}

Seconds build_sah(Trees& trees, const std::vector<Triangle>& triangles,
                  const MachineSettings& machine) {
    trees.bvh = build_bvh_sah(triangles, machine.threads);
    return {};
}

Seconds build_morton(Trees& trees, const std::vector<Triangle>& triangles,
                     const MachineSettings& machine) {
    double seconds = 0;
    trees.bvh = build_lbvh(triangles, machine, seconds);
    return seconds;
}

Seconds build_kd(Trees& trees, const std::vector<Triangle>& triangles,
                 const MachineSettings& machine) {
    trees.kd = build_kd_tree(triangles, {.threads = machine.threads});
    return {};
}

Seconds pack_all(Trees& trees, const std::vector<Triangle>& triangles, const MachineSettings&) {
    std::vector<int> indices(triangles.size());
    std::iota(indices.begin(), indices.end(), 0);
    append_packs(triangles, indices, trees.all_packs);
    return {};
}

constexpr KnownStructure structures[] = {
    {"wide", "eight compressed boxes a node", build_wide_tree},
    {"sah", "binary boxes by area", build_sah},
    {"lbvh", "binary boxes along the Morton curve", build_morton},
    {"kd", "KD-tree", build_kd},
    {"none", "no structure", pack_all},
};

} // namespace

const KnownStructure& known_structure(const std::string& accel) {
    for (const KnownStructure& known : structures)
        if (accel == known.name) return known;
    throw std::logic_error("the table of walks names a structure that nobody builds: " + accel);
}

Trees build_trees(const KnownStructure& structure, Prepare prepare,
                  const std::vector<Triangle>& triangles, const MachineSettings& machine) {
    Trees trees;
    auto start = Clock::now();
    const Seconds alone = structure.build(trees, triangles, machine);
    trees.seconds = alone.value_or(seconds_since(start));
    if (prepare == nullptr) return trees;
    start = Clock::now();
    prepare(trees);
    trees.seconds += seconds_since(start);
    return trees;
}

const std::vector<TrianglePack>& Trees::packs() const {
    for (const auto* packs : {&kd.packs, &bvh.packs, &wide.packs})
        if (!packs->empty()) return *packs;
    return all_packs;
}

int Trees::nodes() const {
    return static_cast<int>(kd.nodes.size() + bvh.nodes.size() + skip.size() + wide.nodes.size());
}

int Trees::depth() const { return std::max({depth_of(kd), bvh.depth, wide.levels}); }

std::size_t Trees::bytes() const {
    return kd.bytes() + bvh.node_bytes() + bvh.pack_bytes() + skip.size() * sizeof(SkipNode) +
           wide.node_bytes() + wide.pack_bytes() + all_packs.size() * sizeof(TrianglePack);
}

StructureView Trees::view(std::span<const Triangle> triangles) const {
    StructureView view;
    view.leaves = {array_of(packs()), {triangles.data(), static_cast<int>(triangles.size())}};
    view.kd = kd.view();
    view.bvh = {array_of(bvh.nodes)};
    view.skip = {array_of(skip)};
    view.wide = {array_of(wide.nodes), wide.extent};
    return view;
}

} // namespace raylab::lab04
