// Tasks 4.7 and 4.8: walks through boxes without a stack find what brute force finds, to the last
// bit, and end.
#include "common/task/facts.h"
#include "labs/04_accel/tests/bvh_cases.h"

namespace raylab::lab04 {

namespace {

using namespace task;

void find_all(const std::string& what, std::vector<Triangle> triangles,
              const std::vector<Ray>& rays, BoxWalk walk, const std::string& when_endless,
              const std::string& cause) {
    const std::string wrong = difference(BvhCase(std::move(triangles)), walk, rays);
    const bool endless = wrong.find("does not end") != std::string::npos;
    expect(wrong.empty(), fmt::format("{}: {}; the likely cause: {}", what, wrong,
                                      endless ? when_endless : cause));
}

void find_everything(BoxWalk walk, const std::string& when_endless, const std::string& cause) {
    find_all("500 triangles anywhere", soup(500, 0.3f), any_rays(3000), walk, when_endless, cause);
    find_all("512 triangles of a surface", hills(16), any_rays(3000), walk, when_endless, cause);
    find_all("400 triangles on a grid", on_grid(400), grid_rays(3000), walk, when_endless, cause);
    for (const int n : {0, 1, 8, 9, 17})
        find_all(fmt::format("{} triangles", n), soup(n, 1), any_rays(300), walk, when_endless,
                 "a tree without nodes, or a root with one leaf");
}

// Among two leaves on each axis, in both directions.
void keep_to_good_habits(BoxWalk kind, bool near_first, const std::string& when_endless) {
    for (int axis = 0; axis < 3; ++axis)
        for (const bool down : {false, true}) {
            const TwoCrowds crowds(axis, down);
            const BvhCase scene(crowds.triangles);
            const std::string wrong = WalkHabits{name(kind), near_first, when_endless}.wrong(
                scene.packs(kind), crowds, scene,
                [&](const BvhCase& tree, Notes& notes) { tree.walk(kind, notes); });
            if (!expect(wrong.empty(),
                        fmt::format("along {} {}: {}", down ? "-" : "+", char('x' + axis), wrong)))
                return;
        }
}

// What a ray visits, on average.
struct Visits {
    double nodes = 0, packs = 0;
};
Visits visits(const BvhCase& scene, BoxWalk walk, const std::vector<Ray>& rays = rays_down(3000)) {
    Visits mean;
    for (const Ray& ray : rays) {
        const Answer answer = scene.answer(walk, ray);
        const WalkCounts counts = answer.closest;
        if (answer.endless) return {double(counts.nodes), double(counts.packs)}; // one is enough
        mean.nodes += counts.nodes / double(rays.size());
        mean.packs += counts.packs / double(rays.size());
    }
    return mean;
}

bool contains(const Bounds& outer, const Bounds& inner) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(outer.low[axis] <= inner.low[axis] && outer.high[axis] >= inner.high[axis]))
            return false;
    return true;
}

// The place after all that is below line[at], found by going through it; -1 if a link is wrong. An
// inner node has two children, the root of a tree of one leaf has one.
int end_of(const std::vector<SkipNode>& line, int at) {
    const SkipNode& node = line[at];
    int end = at + 1, children = 0;
    for (; node.pack < 0 && end < node.skip; ++children) {
        if (end >= int(line.size()) || !contains(node.box, line[end].box)) return -1;
        end = end_of(line, end);
        if (end < 0) return -1;
    }
    return end == node.skip && children <= 2 ? end : -1;
}

TEST(Task4_7, EachLinkLeadsPastWhatIsBelow) {
    for (const auto& triangles : {hills(12), soup(300, 0.3f), soup(2, 1)}) {
        const BvhCase scene(triangles);
        std::vector<int> seen(scene.tree.packs.size());
        for (const SkipNode& node : scene.line)
            if (node.pack >= 0) ++seen[node.pack];
        for (const int times : seen)
            if (!expect_equal("places of a pack of triangles in the line", times, 1,
                              "each leaf of the tree stands in the line once"))
                return;
        int at = 0;
        while (at >= 0 && at < int(scene.line.size())) at = end_of(scene.line, at);
        if (!expect(at == int(scene.line.size()),
                    "a node's skip link should lead to the first node that is not below it, its "
                    "first child should be the next in the line, and its box should contain its "
                    "children's; the likely cause: skip is set before all that is below is laid"))
            return;
    }
}

TEST(Task4_7, ItVisitsTheLeavesThatARayComesTo) {
    keep_to_good_habits(BoxWalk::skip, false,
                        "a link that leads back, or a walk that stays at a leaf");
}

TEST(Task4_7, RaysFindWhatBruteForceFinds) {
    find_everything(
        BoxWalk::skip, "a link that leads back, or a walk that stays at a leaf",
        "a leaf on the way is passed over: on a miss go to node.skip, which is the next "
        "node of the walk, else to the next in the line");
}

TEST(Task4_7, NothingBehindAHitIsLookedAt) {
    const BvhCase dense(soup(3000, 0.4f));
    const std::vector<Ray> rays = any_rays(1000);
    const Visits stack = visits(dense, BoxWalk::stack, rays),
                 skip = visits(dense, BoxWalk::skip, rays);
    expect(skip.packs <= 2 * stack.packs,
           fmt::format("among 3000 large triangles a ray tests {:.1f} packs by skip links, with a "
                       "stack {:.1f}; the likely cause: boxes are not tested against query.reach()",
                       skip.packs, stack.packs));
}

TEST(Task4_7, AMissSkipsWhatIsBelow) {
    const BvhCase scene(hills(100));
    const Visits stack = visits(scene, BoxWalk::stack), skip = visits(scene, BoxWalk::skip);
    expect(
        skip.nodes <= 6 * stack.nodes,
        fmt::format("a ray visits {:.1f} nodes by skip links of the {} there are, and {:.1f} "
                    "with a stack, where one is a pair; the likely cause: links lead to the next "
                    "node",
                    skip.nodes, scene.line.size(), stack.nodes));
}

TEST(Task4_8, ItVisitsTheLeavesThatARayComesTo) {
    keep_to_good_habits(BoxWalk::parent, true,
                        "the walk comes back from a leaf as from any child, and back from the far "
                        "child it goes up");
}

TEST(Task4_8, RaysFindWhatBruteForceFinds) {
    find_everything(BoxWalk::parent,
                    "coming back from the far child the walk must go up, not down again",
                    "a child is passed over: a walk that goes down comes from above, to the near "
                    "child, and back from the near child, or where that is missed, it looks at the "
                    "far one");
}

TEST(Task4_8, ARayVisitsAsManyPacksAsWithAStack) {
    const BvhCase scene(hills(100));
    const Visits stack = visits(scene, BoxWalk::stack), parents = visits(scene, BoxWalk::parent);
    expect(parents.nodes <= 3 * stack.nodes,
           fmt::format("a ray visits {:.1f} nodes by parent pointers, with a stack {:.1f}, and "
                       "should visit at most 3 times as many; the likely cause: children that the "
                       "ray misses are gone into",
                       parents.nodes, stack.nodes));
    expect(parents.packs <= 1.25 * stack.packs,
           fmt::format("a ray tests {:.2f} packs by parent pointers, with a stack {:.2f}; the "
                       "likely cause: the far child is visited first",
                       parents.packs, stack.packs));
}

} // namespace

} // namespace raylab::lab04
