// Task 4.1: a KD-tree holds every triangle where a ray can meet it, parts space so that few are
// tested, and stays small whatever the triangles.
#include "common/task/facts.h"
#include "labs/04_accel/tests/kd_cases.h"

namespace raylab::lab04 {

namespace {

using namespace task;

// Through the walk with a stack, which is given.
bool finds_all(const std::string& what, std::vector<Triangle> triangles,
               const std::vector<Ray>& rays,
               const char* cause = "a triangle that reaches across the plane must be in both "
                                   "children, in each with its own part") {
    const KdCase scene(std::move(triangles), deep());
    const std::string wrong = difference(scene, KdWalk::stack, rays);
    return expect(wrong.empty(), fmt::format("{}: {}; the likely cause: {}", what, wrong, cause));
}

// A box for each triangle.
std::vector<KdReference> boxes(const std::vector<Bounds>& all) {
    std::vector<KdReference> references;
    for (const Bounds& box : all) references.push_back({box, int(references.size())});
    return references;
}

double half_area_of(const Vec3& low, const Vec3& high) {
    const DVec3 d = DVec3(high) - DVec3(low);
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

// What the plane costs by definition, and by the formulas that are often written in its place.
struct CostOfPlane {
    CostOfPlane(const std::vector<KdReference>& references, const Bounds& cell,
                const KdPlane& plane, const KdCosts& costs) {
        for (const KdReference& reference : references) {
            below += reference.box.low[plane.axis] < plane.at;
            above += reference.box.high[plane.axis] > plane.at;
        }
        Vec3 middle_high = cell.high, middle_low = cell.low;
        middle_high[plane.axis] = middle_low[plane.axis] = plane.at;
        const double area = half_area_of(cell.low, cell.high),
                     lower = half_area_of(cell.low, middle_high),
                     upper = half_area_of(middle_low, cell.high);
        const double factor = below == 0 || above == 0 ? costs.empty_factor : 1;
        const int p = packs_for(below), q = packs_for(above);
        right = factor * (costs.step + (lower * p + upper * q) / area);
        wrong = {
            {(costs.step + (lower * p + upper * q) / area),
             "a plane with no triangle on one side is empty_factor times as dear"},
            {factor * (costs.step + (upper * p + lower * q) / area),
             "the children's areas are taken for each other"},
            {factor * (costs.step + lower * p + upper * q),
             "what the children cost is not divided by area(cell)"},
            {factor * (lower * p + upper * q) / area, "the step is left out of the cost"},
            {factor * (costs.step + (lower * below + upper * above) / area),
             "the cost is of packs of eight triangles, packs_for(below), not of triangles"},
        };
    }

    const char* cause(double cost, double tolerance) const {
        for (const auto& [value, text] : wrong)
            if (std::fabs(cost - value) <= tolerance) return text;
        return below + above > 16
                   ? "of many triangles a plane has the counts of the bins before it: what began "
                     "in them is below, and what ended in them is no longer above"
                   : "a triangle is below if it begins before the plane, and above if it ends "
                     "behind it";
    }

    int below = 0, above = 0;
    double right;
    std::vector<std::pair<double, const char*>> wrong;
};

std::string axis_name(const KdPlane& plane) {
    return plane.axis < 0 ? "none" : std::string(1, char('x' + plane.axis));
}

std::size_t references(const KdTree& tree) {
    std::size_t n = 0;
    for (const TrianglePack& pack : tree.packs)
        for (const int index : pack.index) n += index >= 0;
    return n;
}

TEST(Task4_1, TheCostIsThatOfThePlane) {
    for (const int n : {12, 20, 500}) {
        Dice dice(12);
        const Bounds cell{Vec3(0), Vec3(3, 1, 1)};
        std::vector<Bounds> all;
        for (int i = 0; i < n; ++i) {
            const Vec3 low = dice.point(0, 0.8f) * Vec3(3.5f, 1, 1);
            all.push_back({low, low + Vec3(0.2f)});
        }
        // With a step so cheap, some plane costs less than a leaf, and is found.
        const KdCosts costs{.step = 0.1, .empty_factor = 0.9};
        const std::vector<KdReference> references = boxes(all);
        const KdPlane plane = best_plane(references, cell, costs);
        if (!expect(plane.axis >= 0, fmt::format("no plane is found for {} boxes", n))) return;
        const CostOfPlane cost(references, cell, plane, costs);
        const double tolerance = (n <= 16 ? 1e-5 : 0.005) * cost.right;
        if (!expect_near(fmt::format("the cost of the plane {} = {} for {} boxes, {} of which "
                                     "reach below it and {} above,",
                                     axis_name(plane), plane.at, n, cost.below, cost.above),
                         plane.cost, cost.right, tolerance, cost.cause(plane.cost, tolerance)))
            return;
    }
}

// Where triangles end at a plane and others begin, none of them is on both sides.
TEST(Task4_1, WhatTouchesAPlaneIsOnOneSideOfIt) {
    std::vector<Bounds> all;
    for (int i = 0; i < 16; ++i) {
        const float x = i < 8 ? 0.0f : 1.0f;
        all.push_back({Vec3(x, 0, 0), Vec3(x + 1, 1, 1)});
    }
    const KdPlane plane =
        best_plane(boxes(all), {Vec3(0), Vec3(3, 1, 1)}, {.step = 0.1, .empty_factor = 0.9});
    expect(
        plane.axis == 0 && plane.at == 1,
        fmt::format("of eight boxes that end at x = 1 and eight that begin there, the best plane "
                    "should be x = 1 but is {} = {}; the likely cause: at a plane first the ends "
                    "up to it are passed, then it is considered, and then what begins there is "
                    "passed",
                    axis_name(plane), plane.at)) &&
        expect_near("the cost of that plane", plane.cost, 0.1 + (3 * 1 + 5 * 1) / 7.0, 1e-5,
                    "at a plane first the ends up to it are passed, then it is considered, and "
                    "then what begins there is passed");
}

TEST(Task4_1, ACellThatIsFullHasNoPlane) {
    const Bounds cell{Vec3(-1), Vec3(1)};
    for (const int n : {16, 50}) {
        const KdPlane plane = best_plane(boxes(std::vector<Bounds>(n, cell)), cell,
                                         {.step = 0.1, .empty_factor = 0.9});
        expect(plane.axis < 0 || plane.cost >= packs_for(n),
               fmt::format("{} boxes that fill their cell leave no plane to cut it at, but {} = {} "
                           "is taken; the likely cause: a plane must lie strictly inside the cell, "
                           "and not have all triangles on both sides",
                           n, axis_name(plane), plane.at));
    }
}

// A crowd at one end of a long cell: what is empty is cut off at the first box or the last one.
TEST(Task4_1, WhatIsEmptyIsCutOff) {
    for (const int n : {12, 40})
        for (const bool at_the_end : {false, true}) {
            Dice dice(5);
            const Bounds cell{Vec3(1), Vec3(11, 2, 2)};
            std::vector<Bounds> all;
            float first = 11, last = 1;
            for (int i = 0; i < n; ++i) {
                const Vec3 low = dice.point(1, 1.5f) + Vec3(at_the_end ? 9.2f : 0.3f, 0, 0);
                all.push_back({low, low + Vec3(0.4f, 0.5f, 0.5f)});
                first = std::min(first, all.back().low.x);
                last = std::max(last, all.back().high.x);
            }
            const std::vector<KdReference> references = boxes(all);
            const KdPlane plane = best_plane(references, cell, {});
            const float right = at_the_end ? first : last;
            if (!expect(
                    plane.axis == 0 && plane.at == right,
                    fmt::format("{} boxes at the {} of a cell: the best plane should be x = {}, "
                                "where {}, but is {} = {}; the likely cause: {}",
                                n, at_the_end ? "end" : "begin", right,
                                at_the_end ? "the first box begins" : "the last box ends",
                                axis_name(plane), plane.at,
                                n > 16 ? "the place where the first box begins and the place "
                                         "where the last one ends are considered, too"
                                       : "the plane of the least cost is not the one that is "
                                         "kept")))
                return;
            const CostOfPlane cost(references, cell, plane, {});
            if (!expect_near("the cost of that plane", plane.cost, cost.right, 1e-4,
                             cost.cause(plane.cost, 1e-4)))
                return;
        }
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
    expect(
        plane.axis == 0 && plane.at > 0.9f && plane.at < 3.1f,
        fmt::format("two crowds at x < 0.95 and x > 3 should be parted between them but are at "
                    "{} = {}; the likely cause: a triangle is counted in the bin where it begins "
                    "and in the one where it ends, and a plane has the counts of the bins "
                    "before it",
                    axis_name(plane), plane.at));
}

// Two packs are tested in the time of a step, and a cut leaves at least one on either side.
TEST(Task4_1, WhatNoPlaneMakesCheaperIsNotCut) {
    const KdTree tree = build_kd_tree(soup(16, 0.3f));
    expect_equal("nodes of a tree over 16 triangles, two packs, where a step costs two",
                 static_cast<long long>(tree.nodes.size()), 1,
                 "a cell is cut only where the best plane costs less than packs(cell): a leaf "
                 "costs no more here");
}

// Each half gets its part of the box.
TEST(Task4_1, PlanesLieInsideTheirCells) {
    const KdTree tree = build_kd_tree(soup(400, 0.3f), deep());
    std::vector<std::pair<int, Bounds>> open = {{0, tree.bounds}};
    while (!open.empty()) {
        const auto [at, cell] = open.back();
        open.pop_back();
        const KdNode& node = tree.nodes[at];
        if (node.is_leaf()) continue;
        const int axis = node.axis();
        if (!expect(node.split > cell.low[axis] && node.split < cell.high[axis],
                    fmt::format("a cell from {} to {} along {} is cut at {}; the likely cause: the "
                                "halves must get their parts of the box, not the box of the whole "
                                "cell",
                                cell.low[axis], cell.high[axis], char('x' + axis), node.split)))
            return;
        Bounds low = cell, high = cell;
        low.high[axis] = high.low[axis] = node.split;
        open.push_back({node.below(), low});
        open.push_back({node.above(), high});
    }
}

TEST(Task4_1, RaysFindWhatBruteForceFinds) {
    finds_all("400 triangles anywhere", soup(400, 0.3f), any_rays(3000));
    finds_all("512 triangles of a surface", hills(16), any_rays(3000));
    finds_all("3000 small triangles", soup(3000, 0.05f), any_rays(500));
}

TEST(Task4_1, CornersAndRaysInThePlanesAreFound) {
    const char* cause = "a triangle that only touches the plane, or lies in the plane itself, must "
                        "be in one of the children";
    finds_all("400 triangles on a grid", on_grid(400), grid_rays(4000), cause);
    finds_all("36 houses", city(6), grid_rays(4000), cause);
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

TEST(Task4_1, DepthAndMemoryAreBounded) {
    const auto bounded = [](const char* what, const std::vector<Triangle>& triangles,
                            double copies = 3) {
        KdBuildSettings settings = deep();
        settings.copies = copies;
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
    // Crowds that lie ever closer to a corner: some cuts each, one below the other.
    std::vector<Triangle> closer;
    for (int k = 0; k < 10; ++k)
        for (int i = 0; i < 16; ++i) {
            const float s = std::ldexp(1.0f, -4 * k);
            const Vec3 p = s * dice.point(1, 1.01f);
            add(closer, p, p + s * Vec3(0.01f, 0, 0), p + s * Vec3(0, 0.01f, 0.01f));
        }
    bounded("ten crowds, each 16 times closer to a corner than the last", closer, 50);
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
