// Which structure a scene gets, what the ledger says of it, and what happens to a walk without end.
#include "common/task/small_scene.h"
#include "labs/04_accel/accel.h"
#include "labs/04_accel/endless_walk.h"
#include "labs/04_accel/renderer.h"
#include "labs/04_accel/tests/planted_walk.h"

#include <gmock/gmock.h>

namespace raylab::lab04 {

namespace {

using testing::HasSubstr;

template <class Error, class Action> std::string message_of(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(ChooseAccel, AFewTrianglesAreTestedOneByOne) {
    for (const int triangles : {0, 1, few_triangles}) {
        EXPECT_EQ(choose_accel(triangles, {}).walk.accel, "none") << triangles;
        EXPECT_THAT(choose_accel(triangles, {}).why, HasSubstr(std::to_string(few_triangles)));
    }
    EXPECT_EQ(choose_accel(few_triangles + 1, {}).walk.accel, "wide");
    EXPECT_EQ(choose_accel(few_triangles + 1, {}).walk.walk, "trail");
}

TEST(ChooseAccel, WhatIsAskedForIsTaken) {
    for (const KnownWalk& known : known_walks()) {
        const AccelChoice choice = choose_accel(1, {known.accel, known.walk});
        EXPECT_EQ(choice.walk.accel, known.accel);
        EXPECT_EQ(choice.why, "asked for");
        EXPECT_EQ(choice.walk.walk, known.walk);
    }
    EXPECT_EQ(choose_accel(1, {"auto", "ropes"}).walk.accel, "kd");
}

TEST(ChooseAccel, WhatDoesNotExistIsRefusedWithTheWalksThatDo) {
    for (const AccelSettings& settings :
         {AccelSettings{"kd", "skip"}, AccelSettings{"wide", "ropes"},
          AccelSettings{"none", "stack"}}) {
        const std::string text = message_of<SettingsError>([&] { choose_accel(1000, settings); });
        EXPECT_THAT(text, HasSubstr(settings.accel));
        EXPECT_THAT(text, HasSubstr(settings.walk));
        EXPECT_THAT(text, HasSubstr("ropes, restart"));
        EXPECT_THAT(text, HasSubstr("wide: trail"));
    }
}

// Two groups of eight triangles, so two leaves under one node: around the origin, and far to the
// right. Each pixel's ray goes down -z, past x = `at`.
Scene two_groups(float at, int max_depth = 1) {
    std::string shapes;
    for (const int group : {0, 100})
        for (int i = 0; i < 8; ++i)
            shapes +=
                fmt::format(R"({}{{"kind": "triangle", "material": "grey", "vertices":
                                       [[{}, -9, {}], [{}, -9, {}], [{}, 9, {}]]}})",
                            shapes.empty() ? "" : ",", group - 9, -i, group + 9, -i, group, -i);
    return task::small_scene(
        {.materials = R"("grey": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})",
         .shapes = shapes,
         .lights = R"({"kind": "point", "position": [0, 0, 50], "intensity": [1, 1, 1]})",
         .render = fmt::format(R"("max_depth": {}, "spp": 1, "direct_light": "light")", max_depth),
         .camera = fmt::format(R"("position": [{0}, 0, 5], "look_at": [{0}, 0, 0], "up": [0, 1, 0],
                                  "vfov_deg": 0.1)",
                               at),
         .width = 8,
         .height = 4});
}

Ledger ledger_of(const Scene& scene, const AccelSettings& accel, int iterations = 3) {
    const std::unique_ptr<Renderer> renderer =
        make_renderer(scene, {.threads = 1, .wavefront = {.pool = 7}, .accel = accel});
    for (int i = 0; i < iterations; ++i) renderer->add_iteration();
    return renderer->ledger();
}

TEST(WalkLedger, CountsWhatEachRayVisits) {
    const std::uint64_t rays = 8 * 4 * 3;
    const struct {
        AccelSettings accel;
        float at;
        std::uint64_t nodes, packs; // a ray
    } cases[] = {{{"none"}, 0, 0, 2},
                 {{"sah", "stack"}, 0, 1, 1},
                 {{"sah", "stack"}, 50, 1, 0},
                 {{"wide", "trail"}, 100, 1, 1}};
    for (const auto& [accel, at, nodes, packs] : cases) {
        const Ledger ledger = ledger_of(two_groups(at), accel);
        const WalkSums& walks = ledger.bounces.at(0).walks;
        EXPECT_EQ(walks.rays, rays);
        EXPECT_EQ(walks.nodes, nodes * rays) << accel.accel << " at " << at;
        EXPECT_EQ(walks.packs, packs * rays) << accel.accel << " at " << at;
        ASSERT_TRUE(ledger.structure);
        EXPECT_EQ(ledger.structure->shadow_rays.rays, 0u);
    }
}

// From the front of the first group to the light before it: one shadow ray a ray, which looks at
// the root.
TEST(WalkLedger, CountsShadowRaysApart) {
    const Ledger ledger = ledger_of(two_groups(0, 2), {"sah", "stack"});
    const WalkSums& shadow_rays = ledger.structure->shadow_rays;
    EXPECT_EQ(shadow_rays.rays, 8u * 4 * 3);
    EXPECT_EQ(shadow_rays.rays, ledger.shadow_rays);
    EXPECT_EQ(shadow_rays.nodes, shadow_rays.rays);
    EXPECT_EQ(ledger.bounces.at(0).walks.nodes, 8u * 4 * 3);
}

TEST(WalkLedger, DescribesTheStructure) {
    const Ledger ledger = ledger_of(two_groups(0), {"sah", "stack"});
    const StructureFacts& facts = ledger.structure.value();
    EXPECT_EQ(facts.name, "sah");
    EXPECT_EQ(facts.walk, "stack");
    EXPECT_EQ(facts.triangles, 16);
    EXPECT_EQ(facts.nodes, 1);
    EXPECT_EQ(facts.triangle_packs, 2);
    EXPECT_EQ(facts.bytes, sizeof(BvhNode) + 2 * sizeof(TrianglePack));
    EXPECT_GT(facts.build_seconds, 0);
    EXPECT_THAT(to_json(ledger), HasSubstr("\"nodes_per_ray\": 1.0"));
    EXPECT_THAT(to_table(ledger), HasSubstr("16 triangles: sah, asked for"));
}

// A row of spheres along x, each before its own pixels: more than a few groups have a tree.
TEST(WalkLedger, DescribesTheTreeOverSpheres) {
    std::string shapes;
    for (int i = 0; i < 10 * spheres_per_group; ++i)
        shapes += fmt::format(R"({}{{"kind": "sphere", "center": [{}, 0, 0], "radius": 0.4,
                                     "material": "grey"}})",
                              i == 0 ? "" : ",", i);
    const Scene scene = task::small_scene(
        {.materials = R"("grey": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})",
         .shapes = shapes,
         .render = R"("max_depth": 1, "spp": 1)",
         .camera = R"("position": [80, 0, 50], "look_at": [80, 0, 0], "up": [0, 1, 0],
                      "vfov_deg": 0.1)",
         .width = 8,
         .height = 4});
    const Ledger ledger = ledger_of(scene, {});
    EXPECT_FALSE(ledger.structure);
    const ShapeTreeFacts& facts = ledger.shapes.value();
    EXPECT_EQ(facts.spheres, 10 * spheres_per_group);
    EXPECT_EQ(facts.nodes, 9);
    EXPECT_EQ(facts.depth, 4);
    EXPECT_EQ(facts.bytes, 9 * sizeof(BvhNode));
    EXPECT_EQ(facts.rays.rays, 8u * 4 * 3);
    EXPECT_GE(facts.rays.packs, facts.rays.rays);     // one group each,
    EXPECT_LE(facts.rays.packs, 2 * facts.rays.rays); // or two at its end
    EXPECT_THAT(to_json(ledger), HasSubstr("\"groups_per_ray\": 1.0"));
    EXPECT_THAT(to_table(ledger), HasSubstr("160 spheres, 0 quads: boxes over groups of sixteen"));
    EXPECT_FALSE(ledger_of(scene, {"none"}).shapes);
}

TEST(WalkLedger, HasNoStructureWithoutTriangles) {
    const Scene sphere = task::small_scene(
        {.materials = R"("grey": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]})",
         .shapes = R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "grey"})"});
    const Ledger ledger = ledger_of(sphere, {"sah"});
    EXPECT_FALSE(ledger.structure);
    for (const StageCounts& stage : ledger.stages)
        EXPECT_TRUE(!stage.name.starts_with("walk") || stage.launches == 0) << stage.name;
}

// One triangle, and triangles too few for a node, are found in every structure.
TEST(Accel, TreesOfOneLeafAreWalked) {
    for (int triangles = 1; triangles <= 5; ++triangles)
        for (const KnownWalk& known : known_walks()) {
            Scene scene = two_groups(0);
            scene.triangles.resize(triangles);
            const std::unique_ptr<Renderer> renderer =
                make_renderer(scene, {.accel = {known.accel, known.walk}});
            renderer->add_iteration();
            for (const PathRecord& record : renderer->records())
                EXPECT_EQ(record.end, PathEnd::depth)
                    << triangles << " triangles, " << known.accel << ", " << known.walk;
        }
}

// A triangle and a quad in one plane: the one that stands first in the file is seen, whichever
// stage tests it.
TEST(Accel, TiesWithOtherShapesGoToTheLowestId) {
    const std::string triangle = R"({"kind": "triangle", "material": "red", "vertices":
                                     [[-9, -9, 0], [9, -9, 0], [0, 9, 0]]})";
    const std::string quad = R"({"kind": "quad", "material": "green", "vertices":
                                 [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]]})";
    for (const bool triangle_first : {true, false})
        for (const KnownWalk& known : known_walks()) {
            const Scene scene = task::small_scene(
                {.materials = R"("red": {"kind": "diffuse", "reflectance": [0, 0, 0],
                                         "emission": [1, 0, 0]},
                                 "green": {"kind": "diffuse", "reflectance": [0, 0, 0],
                                           "emission": [0, 1, 0]})",
                 .shapes = triangle_first ? triangle + "," + quad : quad + "," + triangle,
                 .render = R"("max_depth": 1, "spp": 1)"});
            const std::unique_ptr<Renderer> renderer =
                make_renderer(scene, {.accel = {known.accel, known.walk}});
            renderer->add_iteration();
            for (const FilmPixel& pixel : renderer->film().pixels)
                ASSERT_EQ(pixel.sum[0], triangle_first) << known.accel;
        }
}

TEST(Accel, ItsBytesCountAgainstTheBudget) {
    const std::string text = message_of<SettingsError>([] {
        Scene scene = two_groups(0);
        scene.triangles.assign(100000, scene.triangles.front());
        make_renderer(scene, {.wavefront = {.memory_budget = 8 << 20}, .accel = {"none"}});
    });
    EXPECT_THAT(text, HasSubstr("the structure over its triangles 3.81 MiB"));
}

TEST(EndlessWalk, StopsTheRenderAndNamesTheRay) {
    const Scene scene = [] {
        Scene two = two_groups(0);
        two.render.jitter = false;
        return two;
    }();
    Accel accel(scene, {.accel = {"sah", "stack"}});
    accel.walk_with(planted_walk());
    const std::unique_ptr<Renderer> renderer =
        make_renderer(scene, {.threads = 1, .block_size = 8}, std::move(accel));
    const std::string text = message_of<EndlessWalk>([&] { renderer->add_iteration(); });
    for (const char* part : {"'sah'", "'stack'", "pixel (4, 0)", "sample 0", "origin (0, 0, 5)",
                             "direction (", "The likely cause: a node"})
        EXPECT_THAT(text, HasSubstr(part));
}

// What was planted is nothing that a sound walk does: no false alarm, in the same scene.
TEST(EndlessWalk, IsNotSaidOfWalksThatEnd) {
    for (const KnownWalk& known : known_walks())
        EXPECT_NO_THROW(ledger_of(two_groups(0), {known.accel, known.walk}));
}

} // namespace

} // namespace raylab::lab04
