// The walks run on the host, ray after ray, as a processor runs them: what a kernel's launch and a
// pool of rays cost is not in their time.
#include "app/lab04_rays.h"

#include "labs/04_accel/bvh/sah.h"
#include "labs/04_accel/bvh/skip_tree.h"
#include "labs/04_accel/bvh/walk_parent.h"
#include "labs/04_accel/bvh/walk_skip.h"
#include "labs/04_accel/bvh/walk_stack.h"
#include "labs/04_accel/bvh/walk_trail.h"
#include "labs/04_accel/kd/build.h"
#include "labs/04_accel/kd/ropes.h"
#include "labs/04_accel/kd/walk_restart.h"
#include "labs/04_accel/kd/walk_ropes.h"
#include "labs/04_accel/kd/walk_stack.h"
#include "labs/04_accel/lbvh/host.h"
#include "labs/04_accel/structure.h"
#include "labs/04_accel/wide/tree.h"
#include "labs/04_accel/wide/walk_stack.h"
#include "labs/04_accel/wide/walk_trail.h"

#include <optional>
#include <utility>

namespace raylab::app {

namespace {

using namespace lab04;
using namespace bench;

template <class T> Array<T> array_of(const std::vector<T>& values) {
    return {values.data(), static_cast<int>(values.size())};
}

// What a builder leaves on the host: one of the trees.
struct Trees {
    KdTree kd;
    BvhTree bvh;
    std::vector<SkipNode> skip;
    WideTree wide;
    const std::vector<TrianglePack>* packs = nullptr;
    double bytes = 0;

    StructureView view(std::span<const Triangle> triangles) const {
        StructureView view;
        view.leaves = {array_of(*packs), {triangles.data(), static_cast<int>(triangles.size())}};
        view.kd = kd.view();
        view.bvh = {array_of(bvh.nodes)};
        view.skip = {array_of(skip)};
        view.wide = {array_of(wide.nodes), wide.extent};
        return view;
    }
};

// Returns its seconds, if what has passed is not what it took.
using Builder = std::optional<double> (*)(Trees& trees, const std::vector<Triangle>& triangles,
                                          int threads);

std::optional<double> build_kd(Trees& trees, const std::vector<Triangle>& triangles, int threads) {
    trees.kd = build_kd_tree(triangles, {.threads = threads});
    trees.packs = &trees.kd.packs;
    trees.bytes = double(trees.kd.bytes());
    return std::nullopt;
}

std::optional<double> build_kd_with_ropes(Trees& trees, const std::vector<Triangle>& triangles,
                                          int threads) {
    trees.kd = build_kd_tree(triangles, {.threads = threads});
    lay_ropes(trees.kd);
    trees.packs = &trees.kd.packs;
    trees.bytes = double(trees.kd.bytes());
    return std::nullopt;
}

std::optional<double> build_sah(Trees& trees, const std::vector<Triangle>& triangles, int threads) {
    trees.bvh = build_bvh_sah(triangles, threads);
    trees.packs = &trees.bvh.packs;
    trees.bytes = double(trees.bvh.node_bytes() + trees.bvh.pack_bytes());
    return std::nullopt;
}

// On the device, whose copies are not part of building.
std::optional<double> build_morton(Trees& trees, const std::vector<Triangle>& triangles,
                                   int threads) {
    double seconds = 0;
    trees.bvh = build_lbvh(triangles, threads, seconds);
    trees.packs = &trees.bvh.packs;
    trees.bytes = double(trees.bvh.node_bytes() + trees.bvh.pack_bytes());
    return seconds;
}

// The binary nodes are not needed once the links are laid.
std::optional<double> build_skip(Trees& trees, const std::vector<Triangle>& triangles,
                                 int threads) {
    build_sah(trees, triangles, threads);
    trees.skip = lay_skip_links(trees.bvh);
    trees.bytes = double(trees.skip.size() * sizeof(SkipNode) + trees.bvh.pack_bytes());
    trees.bvh.nodes = {};
    return std::nullopt;
}

std::optional<double> build_eight_wide(Trees& trees, const std::vector<Triangle>& triangles,
                                       int threads) {
    trees.wide = build_wide(build_bvh_sah(triangles, threads));
    trees.packs = &trees.wide.packs;
    trees.bytes = double(trees.wide.node_bytes() + trees.wide.pack_bytes());
    return std::nullopt;
}

// walk(structure, query): one of the lab's.
template <class Walk> class WalkedTree : public RayStructure {
  public:
    WalkedTree(std::unique_ptr<Trees> trees, std::span<const Triangle> triangles, int threads)
        : trees_(std::move(trees)), view_(trees_->view(triangles)), threads_(threads) {}

    double closest(std::span<const Ray> rays, std::span<RayAnswer> answers) const override {
        return seconds_in_parts(rays.size(), threads_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                ClosestHit query(view_.leaves, rays[i]);
                Walk()(view_, query);
                answers[i] = {query.hit().t, query.hit().index};
            }
        });
    }
    double any(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override {
        return seconds_in_parts(rays.size(), threads_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                AnyHit query(view_.leaves, rays[i]);
                Walk()(view_, query);
                blocked[i] = query.found();
            }
        });
    }

    std::optional<RayCounts> count_closest(std::span<const Ray> rays) const override {
        return count<ClosestHit>(rays);
    }
    std::optional<RayCounts> count_any(std::span<const Ray> rays) const override {
        return count<AnyHit>(rays);
    }

  private:
    template <class Query> RayCounts count(std::span<const Ray> rays) const {
        RayCounts counts;
        for (const Ray& ray : rays) {
            Query query(view_.leaves, ray);
            Walk()(view_, query);
            counts.nodes += query.counts().nodes;
            counts.triangles += double(query.counts().packs) * triangles_per_pack;
        }
        return counts;
    }

    std::unique_ptr<Trees> trees_;
    StructureView view_;
    int threads_;
};

template <class Walk>
RayContestant contestant(const char* name, const char* title, Builder build, Walk) {
    return {name, title, true, std::numeric_limits<double>::infinity(),
            [build](std::span<const Triangle> triangles, int threads) {
                const std::vector<Triangle> copied(triangles.begin(), triangles.end());
                auto trees = std::make_unique<Trees>();
                const auto start = std::chrono::steady_clock::now();
                const std::optional<double> alone = build(*trees, copied, threads);
                const double seconds = alone.value_or(seconds_since(start)), bytes = trees->bytes;
                return BuiltStructure{
                    std::make_unique<WalkedTree<Walk>>(std::move(trees), triangles, threads),
                    seconds, bytes};
            }};
}

} // namespace

std::vector<RayContestant> lab04_ray_contestants() {
    using View = StructureView;
    return {
        contestant("kd_stack", "KD-tree, a stack", build_kd,
                   [](const View& s, auto& query) { walk_kd_stack(s.kd, query); }),
        contestant("kd_ropes", "KD-tree, ropes", build_kd_with_ropes,
                   [](const View& s, auto& query) { walk_kd_ropes(s.kd, query); }),
        contestant("kd_restart", "KD-tree, from the root again", build_kd,
                   [](const View& s, auto& query) { walk_kd_restart(s.kd, query); }),
        contestant("lbvh_trail", "binary boxes along the Morton curve, a trail of bits",
                   build_morton, [](const View& s, auto& query) { walk_bvh_trail(s.bvh, query); }),
        contestant("sah_stack", "binary boxes by area, a stack", build_sah,
                   [](const View& s, auto& query) { walk_bvh_stack(s.bvh, query); }),
        contestant("sah_skip", "binary boxes by area, skip links", build_skip,
                   [](const View& s, auto& query) { walk_bvh_skip(s.skip, query); }),
        contestant("sah_parent", "binary boxes by area, parent pointers", build_sah,
                   [](const View& s, auto& query) { walk_bvh_parent(s.bvh, query); }),
        contestant("sah_trail", "binary boxes by area, a trail of bits", build_sah,
                   [](const View& s, auto& query) { walk_bvh_trail(s.bvh, query); }),
        contestant("wide_stack", "eight compressed boxes a node, a stack", build_eight_wide,
                   [](const View& s, auto& query) { walk_wide_stack(s.wide, query); }),
        contestant("wide_trail", "eight compressed boxes a node, a trail of bits", build_eight_wide,
                   [](const View& s, auto& query) { walk_wide_trail(s.wide, query); }),
    };
}

} // namespace raylab::app
