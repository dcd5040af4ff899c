// Task 4.9: a cut between triangles is the one at which rays pay least, and its cost is what it
// says.
#include "common/task/facts.h"
#include "labs/04_accel/bvh/split.h"
#include "labs/04_accel/tests/bvh_cases.h"

namespace raylab::lab04 {

namespace {

using namespace task;

// Boxes of this size anywhere in `place`.
void add_boxes(std::vector<BuildItem>& items, int n, const Bounds& place, float size, Dice& dice) {
    for (int i = 0; i < n; ++i) {
        Vec3 low;
        for (int axis = 0; axis < 3; ++axis)
            low[axis] = dice.between(place.low[axis], place.high[axis]);
        items.push_back({{low, low + dice.point(0, size)}, int(items.size())});
    }
}

struct Halves {
    Bounds box[2];
    int n[2] = {0, 0};

    void add(int half, const BuildItem& item) {
        box[half].include(item.box);
        ++n[half];
    }
    double cost() const {
        double sum = 0;
        for (int half = 0; half < 2; ++half) sum += half_area(box[half]) * packs_for(n[half]);
        return sum;
    }
    double overlap() const {
        const Bounds both{glm::max(box[0].low, box[1].low), glm::min(box[0].high, box[1].high)};
        return glm::any(glm::greaterThan(both.low, both.high)) ? 0 : half_area(both);
    }
};

// What the cut makes of the items: those before `middle`, and the others.
Halves halves(const std::vector<BuildItem>& items, std::size_t middle) {
    Halves made;
    for (std::size_t i = 0; i < items.size(); ++i) made.add(i >= middle, items[i]);
    return made;
}

const char* axis_name(int axis) {
    return axis < 0 ? "none" : axis == 0 ? "x" : axis == 1 ? "y" : "z";
}

TEST(Task4_9, TheCostIsThatOfWhatTheCutMakes) {
    for (const int n : {5, 20, 100, 1000}) {
        Dice dice(n);
        std::vector<BuildItem> items;
        add_boxes(items, n, {Vec3(4), Vec3(7, 6, 5)}, 0.8f, dice);
        const Bounds centres = centres_of(items);
        const Split split = best_cut_between(items, centres);
        if (!expect(split.axis >= 0,
                    fmt::format("no cut is found between {} boxes; the likely cause: each item "
                                "counts as beginning and as ending in its slice",
                                n)))
            return;
        const Halves made = halves(items, cut_between(items, centres, split));
        if (!expect(made.n[0] > 0 && made.n[1] > 0,
                    fmt::format("the best cut between {} boxes leaves {} on the left and {} on the "
                                "right; the likely cause: a plane with nothing on one side parts "
                                "nothing",
                                n, made.n[0], made.n[1])))
            return;
        const std::string what = fmt::format("the best cut between {} boxes leaves {} and {}; its ",
                                             n, made.n[0], made.n[1]);
        if (!expect_near(what + "cost", split.cost, made.cost(), 1e-5 * made.cost(),
                         "cost = area(L) packs(L) + area(R) packs(R), of the whole boxes around "
                         "all that is left and all that is right of this plane, begun with nothing "
                         "and not at the origin; a pack for each eight or part of it"))
            return;
        expect_near(what + "overlap", split.overlap, made.overlap(), 1e-5 * made.cost(),
                    "overlap is the area of the box that both halves cover, 0 if there is none");
    }
}

TEST(Task4_9, TwoCrowdsAreParted) {
    for (int axis = 0; axis < 3; ++axis) {
        Dice dice(51 + axis);
        std::vector<BuildItem> items;
        Bounds near{Vec3(0), Vec3(1)}, far = near;
        far.low[axis] = 4, far.high[axis] = 5;
        add_boxes(items, 30, near, 0.2f, dice);
        add_boxes(items, 50, far, 0.2f, dice);
        const Bounds centres = centres_of(items);
        const Split split = best_cut_between(items, centres);
        if (!expect(split.axis >= 0, "no cut is found between two crowds; the likely cause: each "
                                     "item counts as beginning and as ending in its slice") ||
            !expect(split.axis == axis,
                    fmt::format("two crowds lie apart along {}, and the best cut should be across "
                                "it but is across {}; the likely cause: only one axis is tried, or "
                                "a dearer plane takes the place of a cheaper one",
                                axis_name(axis), axis_name(split.axis))))
            return;
        const std::size_t left = cut_between(items, centres, split);
        expect_equal("boxes before the plane between crowds of 30 and 50", (long long)(left), 30,
                     "a plane counts the slices before it as left: plane k parts slice k - 1 from "
                     "slice k");
        expect_equal("the overlap of the halves' boxes, which lie apart, is 0 (1: yes)",
                     split.overlap == 0, 1,
                     "overlap is the area of the box that both halves cover, 0 if there is none");
    }
}

TEST(Task4_9, NoEvenCutIsMuchCheaper) {
    for (int scene = 0; scene < 20; ++scene) {
        Dice dice(60 + scene);
        std::vector<BuildItem> items;
        add_boxes(items, 400, {Vec3(0), Vec3(3, 2, 1)}, 0.1f, dice);
        add_boxes(items, 400, {dice.point(0, 1), Vec3(1)}, 0.02f, dice);
        const Bounds centres = centres_of(items);
        const Split split = best_cut_between(items, centres);
        for (int axis = 0; axis < 3; ++axis) {
            for (int k = 1; k < 8; ++k) {
                const float plane = glm::mix(centres.low[axis], centres.high[axis], k / 8.0f);
                Halves made;
                for (const BuildItem& item : items) made.add(item.centre(axis) >= plane, item);
                if (!expect(split.cost <= 1.1 * made.cost(),
                            fmt::format("the best cut costs {:.4g}, but one at {}/8 of {} only "
                                        "{:.4g}; the likely cause: planes are left out, or the "
                                        "boxes of the right side are those of another plane",
                                        split.cost, k, axis_name(axis), made.cost())))
                    return;
            }
        }
    }
}

// least_cost() spares work, and never a cut that pays: one that costs just less than what was found
// before must be found.
TEST(Task4_9, TheBoundHidesNoCutThroughTriangles) {
    for (int scene = 0; scene < 20; ++scene) {
        Dice dice(80 + scene);
        std::vector<Triangle> triangles; // long and slanted: their boxes overlap
        for (int i = 0; i < 100; ++i) {
            const Vec3 p = dice.point(1, 3);
            add(triangles, p, p + dice.point(-1, 1), p + dice.point(-0.1f, 0.1f));
        }
        const std::vector<BuildItem> items = build_items(triangles);
        Bounds box;
        for (const BuildItem& item : items) box.include(item.box);
        const Split any = best_cut_through(items, box, triangles, infinity);
        const Split dear = best_cut_through(items, box, triangles, 1.0001 * any.cost);
        if (!expect(any.axis < 0 || dear.axis >= 0,
                    fmt::format("a cut through the triangles costs {:.5g}, but is not found where "
                                "the best cut so far costs {:.5g}; the likely cause: least_cost() "
                                "gives a bound that is too high",
                                any.cost, 1.0001 * any.cost)))
            return;
    }
}

TEST(Task4_9, WhatCannotBePartedIsNot) {
    std::vector<BuildItem> items;
    for (int i = 0; i < 100; ++i) items.push_back({{Vec3(1), Vec3(2)}, i});
    const Split split = best_cut_between(items, centres_of(items));
    expect(split.axis < 0, "100 boxes in the same place cannot be parted by their centres, and the "
                           "split should have no axis");
}

TEST(Task4_9, ARayTestsFewTriangles) {
    // A small fine mesh in a large coarse one.
    std::vector<Triangle> triangles = hills(20);
    for (const Triangle& t : hills(60)) {
        const auto place = [](Vec3 v) { return 0.02f * v + Vec3(0.5f, 0.25f, -0.3f); };
        add(triangles, place(t.v[0]), place(t.v[1]), place(t.v[2]));
    }
    const BvhCase scene(triangles);
    const std::vector<Ray> rays = rays_down(2000);
    double nodes = 0, packs = 0;
    for (const Ray& ray : rays) {
        const WalkCounts counts = scene.answer(BoxWalk::stack, ray).closest;
        nodes += counts.nodes / double(rays.size()), packs += counts.packs / double(rays.size());
    }
    const char* cause = "the cut is not where the surface area heuristic has its least";
    expect(nodes <= 18, fmt::format("of {} triangles a ray visits {:.1f} nodes, at most 18 are "
                                    "needed; the likely cause: {}",
                                    triangles.size(), nodes, cause));
    expect(packs <= 2.5, fmt::format("of {} triangles a ray tests {:.2f} packs, at most 2.5 are "
                                     "needed; the likely cause: {}",
                                     triangles.size(), packs, cause));
}

TEST(Task4_9, RaysFindWhatBruteForceFinds) {
    for (const auto& [what, triangles] : {std::pair{"500 triangles anywhere", soup(500, 0.3f)},
                                          {"512 triangles of a surface", hills(16)},
                                          {"one triangle 300 times", identical(300)}}) {
        const std::string wrong = difference(BvhCase(triangles), BoxWalk::stack, any_rays(2000));
        expect(wrong.empty(),
               fmt::format("{}: {}; the likely cause: a cut that loses triangles", what, wrong));
    }
}

} // namespace

} // namespace raylab::lab04
