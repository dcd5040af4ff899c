// Renderer::restart(): the bits are those of a new renderer of a scene with that camera and seed,
// whatever was drawn before, and what was built over the shapes stays.
#include "app/tests/agreement.h"

#include <gtest/gtest.h>

namespace raylab::app {

namespace {

constexpr std::uint32_t other_seed = 77;

// The scene's camera, a step aside.
Camera moved(Camera camera) {
    camera.position += 0.05f * camera.focus_distance * camera.right;
    return camera;
}

Camera with_lens(Camera camera) {
    camera.lens_radius = 0.1f * camera.focus_distance;
    return camera;
}

// What a renderer has after some iterations: film, records and ledger. The ledger is compared
// without its seconds and without its batches, which depend on what the previous renderer left in
// the machine.
struct State {
    Film film;
    std::vector<PathRecord> records;
    std::string ledger;
};

// The JSON text without the values of a key, up to the comma or the end of the line.
std::string without(std::string text, const std::string& key) {
    const std::string name = '"' + key + "\": ";
    for (std::size_t begin; (begin = text.find(name)) != std::string::npos;)
        text.erase(begin, text.find_first_of(",\n", begin) - begin);
    return text;
}

State draw(Renderer& renderer, const Scene& scene, int spp) {
    add_samples(renderer, spp);
    std::string ledger = to_json(develop(renderer, scene).ledger);
    for (const char* key : {"build_seconds", "seconds", "batches"}) ledger = without(ledger, key);
    return {renderer.film(), renderer.records(), ledger};
}

void expect_same(const State& a, const State& b, const std::string& what) {
    EXPECT_TRUE(same_bits(a.film, b.film)) << what << ": the films differ";
    ASSERT_EQ(a.records.size(), b.records.size()) << what;
    EXPECT_EQ(
        std::memcmp(a.records.data(), b.records.data(), a.records.size() * sizeof(PathRecord)), 0)
        << what << ": the paths differ";
    EXPECT_EQ(a.ledger, b.ledger) << what << ": the ledgers differ";
}

// A renderer of `scene` that is restarted draws what a new one of the changed scene draws.
void expect_restart_is_new(const Lab& lab, const Scene& scene, const MachineSettings& machine,
                           const Camera& camera, const std::string& what) {
    Scene changed = scene;
    changed.camera = camera;
    changed.render.seed = other_seed;
    const State expected = draw(*lab.make(changed, machine), changed, 2);

    const std::unique_ptr<Renderer> renderer = lab.make(scene, machine);
    const State first = draw(*renderer, scene, 3);
    renderer->restart(camera, other_seed);
    expect_same(draw(*renderer, changed, 2), expected, what);
    renderer->restart(scene.camera, scene.render.seed);
    expect_same(draw(*renderer, scene, 3), first, what + ", and back");
    EXPECT_FALSE(same_bits(first.film, expected.film)) << what << ": camera and seed do not matter";
}

std::vector<MachineSettings> settings_of(const Lab& lab) {
    std::vector<MachineSettings> all = {{.threads = 2}};
    if (lab.has_wavefront)
        for (const WavefrontSettings& wavefront :
             {WavefrontSettings{.compact_every = 0, .pool = 100},
              WavefrontSettings{.sort = MaterialSort::queues, .pool = 300, .shuffle = 9},
              WavefrontSettings{.pool = 90, .shuffle = 5, .regenerate = true}})
            all.push_back({.threads = 1, .wavefront = wavefront});
    if (lab.accels)
        for (const AccelSettings& accel : lab.accels())
            all.push_back({.threads = 1, .wavefront = {.pool = 200}, .accel = accel});
    return all;
}

class EachLab : public testing::TestWithParam<std::string> {};

// A pinhole among quads, Whitted's trees, a lens, and triangles.
TEST_P(EachLab, RestartIsANewRenderer) {
    const Lab& lab = find_lab(GetParam());
    for (const char* name : {"cornell", "whitted", "depth_of_field", "gltf_object"}) {
        const Scene scene = small(name, 16, 5);
        for (const MachineSettings& machine : settings_of(lab))
            expect_restart_is_new(lab, scene, machine, moved(scene.camera), name);
    }
}

// A scene of quads, diffuse, without a lens, may be drawn by a kernel that knows no lens
// (common/scene/variants.h).
TEST_P(EachLab, RestartTakesALensAndGivesItBack) {
    const Scene scene = small("cornell_peers", 16, 5);
    expect_restart_is_new(find_lab(GetParam()), scene, {}, with_lens(scene.camera), "a lens");
}

TEST_P(EachLab, RestartKeepsTheFilmsSize) {
    const Scene scene = small("cornell", 16, 5);
    const std::unique_ptr<Renderer> renderer = find_lab(GetParam()).make(scene, {});
    const State before = draw(*renderer, scene, 1);
    Camera wider = scene.camera;
    set_film_size(wider, 17, 16);
    EXPECT_THROW(renderer->restart(wider, other_seed), std::invalid_argument);
    expect_same(draw(*renderer, scene, 0), before, "after the refusal");
}

// One restart a replicate: the image and its provenance are those of a render with that seed.
TEST_P(EachLab, RendersOfOneRendererAreReplicates) {
    const Scene scene = small("cornell", 16, 5);
    const Lab& lab = find_lab(GetParam());
    const std::unique_ptr<Renderer> renderer = lab.make(scene, {});
    for (const std::uint32_t seed : {1u, 2u, 1u}) {
        Scene seeded = scene;
        seeded.render.seed = seed;
        const std::unique_ptr<Renderer> fresh = lab.make(seeded, {});
        add_samples(*fresh, 2);
        const Image expected = develop(*fresh, seeded).image;
        const Image image = render(*renderer, scene, scene.camera, seed, 2).image;
        EXPECT_TRUE(image.mean == expected.mean && image.error == expected.error) << seed;
        EXPECT_EQ(image.provenance.seed, seed);
        EXPECT_EQ(image.provenance.spp, 2);
    }
}

std::vector<std::string> lab_numbers() {
    std::vector<std::string> numbers;
    for (const Lab& lab : labs()) numbers.push_back(lab.number);
    return numbers;
}

INSTANTIATE_TEST_SUITE_P(Restart, EachLab, testing::ValuesIn(lab_numbers()),
                         [](const auto& info) { return "Lab" + info.param; });

// What camera rays hit is kept from iteration to iteration, and forgotten with the camera.
TEST(Restart, ForgetsTheFirstBounce) {
    const Lab& lab = find_lab("03");
    const Scene scene = small("first_bounce", 16, 5);
    const MachineSettings machine{.wavefront = {.first_bounce_cache = true}};
    expect_restart_is_new(lab, scene, machine, moved(scene.camera), "first bounce");
    const std::unique_ptr<Renderer> renderer = lab.make(scene, machine);
    const State before = draw(*renderer, scene, 2);
    EXPECT_THROW(renderer->restart(with_lens(scene.camera), 1), SettingsError);
    expect_same(draw(*renderer, scene, 0), before, "after the refusal");
}

// Two builds of a structure rarely take the same time to the nanosecond, and two builds of all
// structures never do. So if all build times stay the same, nothing was built again.
TEST(Restart, KeepsTheStructure) {
    const Scene scene = small("gltf_object", 16, 5);
    std::vector<double> built, kept, anew;
    for (const AccelSettings& accel : find_lab("04").accels()) {
        const auto renderer = find_lab("04").make(scene, {.accel = accel});
        built.push_back(renderer->ledger().structure->build_seconds);
        renderer->restart(moved(scene.camera), other_seed);
        add_samples(*renderer, 1);
        kept.push_back(renderer->ledger().structure->build_seconds);
        const auto other = find_lab("04").make(scene, {.accel = accel});
        anew.push_back(other->ledger().structure->build_seconds);
    }
    EXPECT_EQ(kept, built);
    EXPECT_NE(anew, built);
}

} // namespace

} // namespace raylab::app
