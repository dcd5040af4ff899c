// Task 4.1: a KD-tree holds every triangle where a ray can meet it, parts space so that few are
// tested, and stays small whatever the triangles.
#include "common/task/facts.h"
#include "labs/04_accel/tests/kd_cases.h"

namespace raylab::lab04 {

namespace {

using namespace task;

// Through the walk with a stack, which is given.
bool finds_all(const std::string& what, std::vector<Triangle> triangles,
               const std::vector<Ray>& rays) {
    const KdCase scene(std::move(triangles), deep());
    const std::string wrong = difference(scene, KdWalk::stack, rays);
    return expect(wrong.empty(), fmt::format("{}: {}; the likely cause: a triangle that reaches "
                                             "across the plane must be in both children",
                                             what, wrong));
}

std::size_t references(const KdTree& tree) {
    std::size_t n = 0;
    for (const TrianglePack& pack : tree.packs)
        for (const int index : pack.index) n += index >= 0;
    return n;
}

TEST(Task4_1, RaysFindWhatBruteForceFinds) {
    finds_all("400 triangles anywhere", soup(400, 0.3f), any_rays(3000));
    finds_all("512 triangles of a surface", hills(16), any_rays(3000));
    finds_all("3000 small triangles", soup(3000, 0.05f), any_rays(500));
}

TEST(Task4_1, CornersAndRaysInThePlanesAreFound) {
    finds_all("400 triangles on a grid", on_grid(400), grid_rays(4000));
    finds_all("36 houses", city(6), grid_rays(4000));
}

TEST(Task4_1, ARayTestsFewTriangles) {
    const KdCase scene(hills(100));
    double nodes = 0, packs = 0;
    const std::vector<Ray> rays = rays_down(4000);
    for (const Ray& ray : rays) {
        const WalkCounts counts = scene.answer(KdWalk::stack, ray).closest;
        nodes += counts.nodes, packs += counts.packs;
    }
    nodes /= double(rays.size()), packs /= double(rays.size());
    expect(packs <= 20, fmt::format("of 20000 triangles a ray tests {:.1f} packs of eight, at most "
                                    "20 are needed; the likely cause: cells are cut where it "
                                    "costs more than it saves, or not where it saves most",
                                    packs));
    expect(nodes <= 60,
           fmt::format("over 20000 triangles a ray visits {:.1f} nodes, at most 60 are "
                       "needed; the likely cause: cells that no plane makes cheaper "
                       "are cut all the same",
                       nodes));
}

TEST(Task4_1, ThePlaneOfLeastCostIsTaken) {
    // 12 triangles in the lowest tenth of a long cell: what is empty is cut off right behind them.
    Dice dice(5);
    const Bounds cell{Vec3(0), Vec3(10, 1, 1)};
    std::vector<KdReference> references;
    for (int i = 0; i < 12; ++i) {
        const Vec3 low = dice.point(0.3f, 0.5f);
        references.push_back({{low, low + Vec3(0.5f)}, i});
    }
    float end = 0;
    for (const KdReference& reference : references) end = std::max(end, reference.box.high.x);
    const KdPlane plane = best_plane(references, cell, {});
    expect(plane.axis == 0 && plane.at == end,
           fmt::format("the best plane should be x = {} but is {} = {}; the likely cause: the "
                       "children's areas or counts are taken for each other",
                       end, plane.axis < 0 ? "none" : std::string(1, char('x' + plane.axis)),
                       plane.at));
    // Half the surface: cell 10 + 10 + 1, below it 2 end + 1. Twelve triangles are two packs.
    const KdCosts costs;
    expect_near("the cost of that plane", plane.cost,
                costs.empty_factor * (costs.step + 2 * (2 * end + 1) / 21.0), 1e-5,
                "cost = step + (area(L) packs(L) + area(R) packs(R)) / area(cell), times "
                "empty_factor where one side is empty");
}

TEST(Task4_1, PlanesAreTriedAmongMany) {
    // 1000 triangles at each end of a cell, nothing between: one cut parts them.
    Dice dice(6);
    const Bounds cell{Vec3(0), Vec3(4, 1, 1)};
    std::vector<KdReference> references;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 low = dice.point(0, 0.9f) + Vec3(i % 2 == 0 ? 0 : 3, 0, 0);
        references.push_back({{low, low + Vec3(0.05f)}, i});
    }
    const KdPlane plane = best_plane(references, cell, {});
    expect(plane.axis == 0 && plane.at > 0.9f && plane.at < 3.1f,
           fmt::format("two crowds at x < 0.95 and x > 3 should be parted between them but are at "
                       "{} = {}; the likely cause: triangles are counted in the wrong bin",
                       plane.axis < 0 ? "none" : std::string(1, char('x' + plane.axis)), plane.at));
}

TEST(Task4_1, TheCostCountsWhatReachesIntoEachSide) {
    for (const int n : {20, 500}) {
        Dice dice(12);
        const Bounds cell{Vec3(0), Vec3(3, 1, 1)};
        std::vector<KdReference> references;
        for (int i = 0; i < n; ++i) {
            const Vec3 low = dice.point(0, 0.8f) * Vec3(3.5f, 1, 1);
            references.push_back({{low, low + Vec3(0.2f)}, i});
        }
        const KdPlane plane = best_plane(references, cell, {});
        if (!expect(plane.axis >= 0, fmt::format("no plane is found for {} boxes", n))) return;
        int below = 0, above = 0;
        for (const KdReference& reference : references) {
            below += reference.box.low[plane.axis] < plane.at;
            above += reference.box.high[plane.axis] > plane.at;
        }
        const auto area = [](Vec3 d) { return d.x * d.y + d.y * d.z + d.z * d.x; };
        Vec3 low = cell.high, high = cell.high;
        low[plane.axis] = plane.at;
        high[plane.axis] -= plane.at;
        const double cost =
            KdCosts{}.step +
            (area(low) * packs_for(below) + area(high) * packs_for(above)) / area(cell.high);
        expect_near(fmt::format("the cost of the plane for {} boxes, {} of which reach below it "
                                "and {} above,",
                                n, below, above),
                    plane.cost, cost, 0.005 * cost,
                    "a triangle is below if it begins before the plane, and above if it ends "
                    "behind it");
    }
}

TEST(Task4_1, DepthAndMemoryAreBounded) {
    const auto bounded = [](const char* what, const std::vector<Triangle>& triangles) {
        KdBuildSettings settings = deep();
        settings.copies = 3;
        const KdTree tree = build_kd_tree(triangles, settings);
        const int limit = kd_depth_limit(triangles.size());
        expect(depth(tree) <= limit,
               fmt::format("{}: a leaf lies {} cuts deep, the limit is {}; the likely cause: the "
                           "cuts left on a path are not counted",
                           what, depth(tree), limit));
        const double share = double(references(tree)) / double(triangles.size());
        expect(share <= settings.copies,
               fmt::format("{}: leaves hold {:.1f} references a triangle, {:.0f} are allowed; the "
                           "likely cause: settings.copies is not heeded",
                           what, share, settings.copies));
    };
    std::vector<Triangle> needles; // all through the middle
    Dice dice(7);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 d = dice.direction();
        add(needles, d, -d, d + dice.point(-0.01f, 0.01f));
    }
    bounded("20000 times one triangle", identical(20000));
    bounded("triangles of sizes from 2^-60 to 2^59", nested());
    bounded("2000 needles through one point", needles);
    bounded("400 large triangles on a grid", on_grid(400));
}

TEST(Task4_1, NoTriangleAndOne) {
    for (const int n : {0, 1, 2, 5})
        finds_all(fmt::format("{} triangles", n), soup(n, 1), any_rays(300));
}

} // namespace

} // namespace raylab::lab04
