// The walks run on the host, one ray after the other. So their time does not include launching
// kernels or keeping a pool of rays.
#include "app/lab04_rays.h"

#include "labs/04_accel/walk_table.h"

#include <set>
#include <typeindex>
#include <utility>

namespace raylab::app {

namespace {

using namespace lab04;
using namespace bench;

// Walk: a type in the lab's table of walks.
template <class Walk> class WalkedTree : public RayStructure {
  public:
    WalkedTree(Trees trees, std::span<const Triangle> triangles, int threads)
        : trees_(std::move(trees)), view_(trees_.view(triangles)), threads_(threads) {}

    double closest(std::span<const Ray> rays, std::span<RayAnswer> answers) const override {
        return seconds_in_parts(rays.size(), threads_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                ClosestHit query(view_.leaves, rays[i]);
                Walk::walk(view_, query);
                answers[i] = {query.hit().t, query.hit().index};
            }
        });
    }
    double any(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override {
        return seconds_in_parts(rays.size(), threads_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                AnyHit query(view_.leaves, rays[i]);
                Walk::walk(view_, query);
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
            Walk::walk(view_, query);
            counts.nodes += query.counts().nodes;
            counts.triangles += double(query.counts().packs) * triangles_per_pack;
        }
        return counts;
    }

    Trees trees_;
    StructureView view_;
    int threads_;
};

template <class Walk> RayContestant contestant(const KnownStructure& structure) {
    return {std::string(structure.name) + "_" + Walk::name,
            std::string(structure.title) + ", " + Walk::title, true,
            std::numeric_limits<double>::infinity(),
            [&structure](std::span<const Triangle> triangles, int threads) {
                const std::vector<Triangle> copied(triangles.begin(), triangles.end());
                Trees trees =
                    build_trees(structure, prepare_of<Walk>(), copied, {.threads = threads});
                const double seconds = trees.seconds, bytes = double(trees.bytes());
                return BuiltStructure{
                    std::make_unique<WalkedTree<Walk>>(std::move(trees), triangles, threads),
                    seconds, bytes};
            }};
}

} // namespace

// From the slowest structure to the fastest. If several structures have the same kind of nodes, all
// walks take part over the first of them, and over the others only the fastest walk does. Brute
// force is a contestant of the bench itself.
std::vector<RayContestant> lab04_ray_contestants() {
    std::vector<RayContestant> all;
    std::set<std::type_index> seen;
    std::string last;
    auto place = all.begin(); // the next walk of the structure `last` is inserted here
    for_each_walk([&]<class Walk>(const std::string& structure, Walk) {
        const bool fastest = structure != last, fresh = seen.insert(typeid(Walk)).second;
        if (structure == "none" || !(fastest || fresh)) return;
        if (fastest) place = all.begin();
        place = all.insert(place, contestant<Walk>(known_structure(structure))) + 1;
        last = structure;
    });
    return all;
}

} // namespace raylab::app
