// Task 3.1, one path at a time: what each stage must have written when it is done.
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/03_wavefront/pool.h"
#include "labs/03_wavefront/shuffle.h"
#include "labs/03_wavefront/tests/one_path.h"

#include <algorithm>

namespace raylab::lab03 {

namespace {

using namespace task;

constexpr double pi = 3.14159265358979;

// From one unit above a floor straight down to it; or, without one, into the sky.
struct View {
    std::string floor = R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 0, 1],
                            "material": "grey"})";
    std::string lights = R"({"kind": "point", "position": [0, 0, 2], "intensity": [8, 8, 8]})";
    std::string integrator = "path";
    int max_depth = 5;
    std::string camera = R"("position": [0, 0, 1], "look_at": [0, 0, 0], "up": [0, 1, 0],
                            "vfov_deg": 40)";
};
Scene scene(const View& view) {
    return small_scene(
        {.materials = R"("grey": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
            "mirror": {"kind": "mirror", "reflectance": [0.8, 0.8, 0.8]},
            "glass": {"kind": "glass", "ior": 1.5},
            "glow": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [1, 1, 1]})",
         .shapes = view.floor,
         .lights = view.lights,
         .render = fmt::format(R"("integrator": "{}", "max_depth": {}, "spp": 1, "jitter": false,
                                  "roulette": false)",
                               view.integrator, view.max_depth),
         .camera = view.camera,
         .width = 3,
         .height = 3});
}

constexpr const char* sky = R"({"kind": "environment", "radiance": [1, 2, 3]})";

TEST(Task3_1, GenerateStartsAPathForEachPixelOfTheFill) {
    constexpr int first = 10, n = 45; // of the film's 60 pixels; no block of 32 ends there
    const Scene film = small_scene({.materials = "", .shapes = "", .width = 10, .height = 6});
    for (const std::uint32_t shuffle : {0u, 3u}) {
        const Started started = start_paths(film, first, n, shuffle);
        for (int i = 0; i < n; ++i)
            if (!expect_equal(fmt::format("place {} of the list", i), started.listed[i], i,
                              "live[i] is slot i") ||
                !expect_equal(fmt::format("the pixel of slot {}, of pixels from {} on", i, first),
                              started.pixel[i], first + shuffled(i, n, shuffle),
                              "slot i has the path of pixel first + shuffled(i, dealt, shuffle)"))
                return;
        const auto listed = std::count_if(started.listed.begin() + n, started.listed.end(),
                                          [](int slot) { return slot != -1; });
        const auto begun =
            std::count_if(started.pixel.begin() + n, started.pixel.end(),
                          [](std::uint32_t pixel) { return pixel != unwritten_pixel; });
        if (!expect_equal(
                fmt::format("paths and places behind the {} of a fill that are written", n),
                listed + begun, 0,
                "the last block has more threads than there are slots: a thread from n "
                "on, i >= n, must do nothing"))
            return;
    }
}

TEST(Task3_1, IntersectWritesWhatTheRayMeets) {
    const PathState met = follow_path(scene({})).front();
    expect_equal("a ray to a diffuse floor: found() of pool.hit", met.hit, 1,
                 "the hit is not written to pool.hit[slot]") &&
        expect_equal("the kind of the floor's material (0: diffuse) in pool.kind", met.kind, 0,
                     "the kind of the material that was hit is not written to pool.kind[slot]") &&
        expect_equal("rays in the path's record", met.record.length, 1,
                     "record_hit() once a ray") &&
        expect_equal("is the path alive (1: yes)", met.alive, 1, "only a miss ends it here");
}

TEST(Task3_1, ARayThatLeavesTakesTheSkyAlong) {
    const PathState left = follow_path(scene({.floor = "", .lights = sky})).front();
    expect_equal("a ray that leaves: pool.kind", left.kind, no_kind,
                 "no_kind is not written: the shading stage must pass by what met nothing") &&
        expect_equal("is its path alive (1: yes)", left.alive, 0,
                     "a miss ends its path: end_path()") &&
        expect_equal("why it ended (0: escaped)", static_cast<int>(left.record.end), 0,
                     "end_path(pool, slot, PathEnd::escaped)") &&
        expect_near("radiance of a path of throughput 0.5 that leaves to a sky of 2",
                    left.radiance.y, 1, 1e-6, "the throughput times the sky's light is added");
}

TEST(Task3_1, ShadeWritesWhatTheNextBounceReads) {
    const PathState next = follow_path(scene({}))[1];
    const double cosine = next.direction.z;
    expect_equal("a path at a diffuse floor goes on (1: yes)", next.alive, 1,
                 "only a direction that is not valid, roulette and max_depth end it") &&
        expect(cosine > 0, fmt::format("pool.direction's z behind a floor seen from above should "
                                       "be positive but is {:.4g}; the likely cause: the ray that "
                                       "goes on is not written to pool.direction[slot]",
                                       cosine)) &&
        expect_near("pool.origin's z behind a floor at z = 0", next.origin.z, 0, 0.01,
                    "the ray that goes on is not written to pool.origin[slot]") &&
        expect_near("pool.throughput: 0.5 before a surface of reflectance 0.5, and behind it",
                    next.throughput.x, 0.25, 1e-5,
                    "the throughput times the sample's weight is not written") &&
        expect_equal("pool.bounce behind the first surface", next.bounce, 1,
                     "pool.bounce[slot] is not counted on: it tells the depth, and which random "
                     "numbers are next") &&
        expect_near("pool.bsdf_pdf behind a diffuse surface, for its new direction", next.bsdf_pdf,
                    cosine / pi, 1e-5,
                    "the density is not written to pool.bsdf_pdf[slot]: a lamp that the ray meets "
                    "would count in full, though shadow rays count it, too");
}

TEST(Task3_1, ShadeSendsAShadowRay) {
    const PathState sent = follow_path(scene({}))[1];
    expect_equal("a floor below a point light has a shadow ray (1: yes)", sent.sends, 1,
                 "shade_path() returns whether one is on its way") &&
        expect_near("pool.shadow_ray_light: throughput 0.5, reflectance 0.5, 2 below a point light "
                    "of intensity 8",
                    sent.shadow_ray_light.x, 0.5 * (0.5 / pi) * 8 / 4, 1e-5,
                    "throughput * shadow_ray.light, with the throughput before the surface") &&
        expect_equal("shadow rays in the path's record", sent.record.shadow_rays, 1,
                     "send_shadow_ray() once");
}

TEST(Task3_1, TheLastSurfaceOnlyGlows) {
    const PathState last = follow_path(scene({.max_depth = 1}))[1];
    expect_equal("at max_depth 1, is a path alive behind its first surface (1: yes)", last.alive, 0,
                 "the path ends at max_depth surfaces: bounce + 1 == max_depth") &&
        expect_equal("why it ended (3: depth)", static_cast<int>(last.record.end), 3,
                     "end_path(pool, slot, PathEnd::depth)") &&
        expect_equal("shadow rays of its last surface", last.record.shadow_rays, 0,
                     "the last surface sends no shadow ray");
}

TEST(Task3_1, AMirrorLeavesNoDensity) {
    const std::string mirror = R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 0, 1],
                                   "material": "mirror"})";
    const PathState next = follow_path(scene({.floor = mirror}))[1];
    expect(
        next.bsdf_pdf == delta_pdf,
        fmt::format("pool.bsdf_pdf behind a mirror should be delta_pdf but is {:.4g}; the likely "
                    "cause: no shadow ray finds a lamp by way of a mirror, so what the mirror "
                    "shows must count in full",
                    next.bsdf_pdf));
}

// Which random numbers a path gets: those of its pixel, of the sample and of the bounce.
TEST(Task3_1, RandomNumbersBelongToPixelSampleAndBounce) {
    const auto direction = [](const PathBegin& begin) {
        return follow_path(scene({}), begin)[1].direction;
    };
    const Vec3 first = direction({});
    expect(direction({.slot = 0}) == first,
           "the same path in another slot goes on in another direction; the likely cause: random "
           "numbers are keyed by the slot, not by the pixel: sampler_of()") &&
        expect(direction({.sample = 1}) != first,
               "samples 0 and 1 of a pixel go on in the same direction; the likely cause: the "
               "random numbers do not depend on the sample: sampler_of()") &&
        expect(direction({.bounce = 1}) != first,
               "bounces 0 and 1 go on in the same direction; the likely cause: the random numbers "
               "are not those of the bounce: get_bounce(bounce)");
}

// Glass parts the tree: the reflected ray goes on, the refracted one waits.
TEST(Task3_1, GlassPartsWhittedsTree) {
    const View glass{.floor = R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1,
                                  "material": "glass"})",
                     .lights = sky,
                     .integrator = "whitted",
                     .camera = R"("position": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0],
                                  "vfov_deg": 40)"};
    const std::vector<PathState> states = follow_path(scene(glass));
    const PathState &split = states[1], &after = states[2];
    expect_equal("branches that wait behind a glass surface", split.pending, 1,
                 "push_branch() once, for the refracted ray") &&
        expect_equal("the node of the reflected ray, behind node 1", split.node, 2,
                     "the reflected ray is node 2 n, which numbers its random numbers") &&
        expect_equal("the node of the refracted ray", split.newest.node, 3,
                     "the refracted ray is node 2 n + 1") &&
        expect_equal("pool.bounce of the reflected ray", split.bounce, 1,
                     "its depth is not counted on") &&
        expect_equal("the depth of the refracted ray", split.newest.depth, 1,
                     "its depth is not counted on") &&
        expect_near("pool.throughput of the reflected ray at n = 1.5, seen straight on",
                    split.throughput.x, 0.5 * 0.04, 1e-4, "throughput * reflected_weight") &&
        expect_near("the throughput of the refracted ray", split.newest.throughput.x, 0.5 * 0.96,
                    1e-4, "throughput * refracted_weight") &&
        expect(split.direction.z > 0 && split.newest.direction.z < 0,
               "the reflected ray should go back and the refracted one on; the likely cause: "
               "their directions are not written");
    // The reflected ray leaves: the refracted one takes its place.
    expect(after.alive && after.node == 3 && after.pending == 0,
           fmt::format("when the reflected ray has left, the refracted one (node 3) should be the "
                       "slot's, but the path is {} with node {} and {} waiting; the likely cause: "
                       "a miss must go on with the tree's next_branch()",
                       after.alive ? "alive" : "ended", after.node, after.pending));
}

TEST(Task3_1, ADiffuseSurfaceEndsABranchOfWhittedsTree) {
    const View room{.floor = R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1,
                                 "material": "glass"},
                                {"kind": "sphere", "center": [0, 0, 0], "radius": 20,
                                 "material": "glow"})",
                    .lights = "",
                    .integrator = "whitted",
                    .camera = R"("position": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0],
                                 "vfov_deg": 40)"};
    for (const int depth : {2, 5}) {
        View view = room;
        view.max_depth = depth;
        const PathState state = follow_path(scene(view))[3];
        expect_near("radiance when the reflected ray has met a wall that glows with 1",
                    state.radiance.x, 0.5 * 0.04, 1e-4, "throughput * emission is added") &&
            expect(state.alive && state.node == 3 && state.pending == 0,
                   fmt::format("behind a diffuse surface of a branch (max_depth {}) the refracted "
                               "ray (node 3) should be the slot's, but the path is {} with node {} "
                               "and {} waiting; the likely cause: {} must go on with the tree's "
                               "next_branch()",
                               depth, state.alive ? "alive" : "ended", state.node, state.pending,
                               depth == 2 ? "the last surface" : "a surface that does not part"));
    }
}

} // namespace

} // namespace raylab::lab03
