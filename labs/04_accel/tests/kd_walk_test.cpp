// Task 4.3: walks without a stack find what brute force finds, to the last bit, and end.
#include "common/task/facts.h"
#include "labs/04_accel/tests/kd_cases.h"

namespace raylab::lab04 {

namespace {

using namespace task;

constexpr KdWalk without_stack[] = {KdWalk::ropes, KdWalk::restart};

constexpr const char* get_past = "the ray must get past the plane at which the last leaf ended";

// Why a walk gets past leaves that it should visit.
const char* passed_over(KdWalk kind) {
    return kind == KdWalk::ropes
               ? "a leaf is passed over: of the three faces that the ray moves towards the one of "
                 "least t is the way out, and its own rope leads on"
               : "a leaf is passed over: a leaf ends at the first plane behind its begin, and the "
                 "root moves down only while all of the rest lies in one child";
}

void find_all(const std::string& what, std::vector<Triangle> triangles,
              const std::vector<Ray>& rays, const char* cause = nullptr) {
    const KdCase scene(std::move(triangles), deep());
    for (const KdWalk kind : without_stack) {
        const std::string wrong = difference(scene, kind, rays);
        const bool endless = wrong.find("does not end") != std::string::npos;
        expect(wrong.empty(), fmt::format("{}: {}; the likely cause: {}", what, wrong,
                                          endless ? get_past
                                          : cause ? cause
                                                  : passed_over(kind)));
    }
}

TEST(Task4_3, ItVisitsTheLeavesThatARayComesTo) {
    for (const KdWalk kind : without_stack)
        for (const bool down : {false, true})
            for (int axis = 0; axis < 3; ++axis) {
                const TwoCrowds crowds(axis, down);
                const KdCase scene(crowds.triangles, deep());
                std::string wrong = WalkHabits{name(kind), true, get_past}.wrong(
                    scene.tree.packs, crowds, scene,
                    [&](const KdCase& tree, Notes& notes) { walk(kind, tree.tree.view(), notes); });
                const std::string which = "a leaf on the way is passed over";
                if (wrong.ends_with(which))
                    wrong.replace(wrong.size() - which.size(), which.size(), passed_over(kind));
                if (!expect(wrong.empty(),
                            fmt::format("along {} {}: {}{}", down ? "-" : "+", char('x' + axis),
                                        wrong,
                                        down ? ", or the ray's direction is forgotten: along a "
                                               "negative axis it moves towards the lower face, and "
                                               "the upper child is the first"
                                             : "")))
                    return;
            }
}

TEST(Task4_3, RaysFindWhatBruteForceFinds) {
    find_all("500 triangles anywhere", soup(500, 0.3f), any_rays(3000));
    find_all("512 triangles of a surface", hills(16), any_rays(3000));
}

TEST(Task4_3, RaysInSplitPlanesAreFoundAndEnd) {
    const char* cause = "a ray that meets two planes at the same t must get past both, and one "
                        "that has met a plane at t is behind it from t on";
    find_all("400 triangles on a grid", on_grid(400), grid_rays(4000), cause);
    find_all("36 houses", city(6), grid_rays(4000), cause);
}

TEST(Task4_3, NoTriangleAndOne) {
    for (const int n : {0, 1, 5})
        find_all(fmt::format("{} triangles", n), soup(n, 1), any_rays(300),
                 "a tree without nodes, or with only a root");
}

TEST(Task4_3, RopesSaveTheWayDownAgain) {
    const KdCase scene(hills(100));
    double nodes[3] = {}, packs[3] = {};
    const std::vector<Ray> rays = rays_down(3000);
    for (const Ray& ray : rays) {
        for (int kind = 0; kind < 3; ++kind) {
            const Answer answer = scene.answer(kd_walks[kind], ray);
            if (!expect(!answer.endless, name(kd_walks[kind]) + " does not end")) return;
            const WalkCounts counts = answer.closest;
            nodes[kind] += counts.nodes / double(rays.size());
            packs[kind] += counts.packs / double(rays.size());
        }
    }
    const double stack = nodes[0], ropes = nodes[1], restart = nodes[2];
    expect(ropes <= 1.05 * stack,
           fmt::format("along ropes a ray visits {:.1f} nodes, with a stack {:.1f}, and should "
                       "visit no more; the likely cause: the walk begins at the root again",
                       ropes, stack));
    expect(restart <= 4 * stack,
           fmt::format("restarting, a ray visits {:.1f} nodes, with a stack {:.1f}, and should "
                       "visit at most 4 times as many; the likely cause: the walk does not end "
                       "where what is left lies behind the hit",
                       restart, stack));
    for (int kind = 1; kind < 3; ++kind)
        expect(packs[kind] <= 1.05 * packs[0],
               fmt::format("{} tests {:.2f} packs a ray, that with a stack {:.2f}; the likely "
                           "cause: leaves are visited that the ray does not come to, or twice",
                           name(kd_walks[kind]), packs[kind], packs[0]));
}

} // namespace

} // namespace raylab::lab04
