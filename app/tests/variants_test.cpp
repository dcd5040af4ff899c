// A scene looks the same in every kernel variant that covers its features, to the bit: what a
// variant leaves out is only what the scene does not have.
#include "app/tests/accuracy.h"
#include "common/scene/scene_features.h"
#include "common/scene/variants.h"
#include "labs/02_iterative/path.h"

namespace raylab::app {

namespace {

struct Rendered {
    std::vector<Vec3> radiance;
    std::vector<std::uint32_t> hits;
};

template <Features F> Rendered render(const Scene& scene) {
    const SceneView v = view(scene);
    Rendered rendered;
    for (int pixel = 0; pixel < v.camera.width * v.camera.height; ++pixel)
        for (std::uint32_t sample = 0; sample < 2; ++sample) {
            const Sampler sampler = {scene.render.sampler, scene.render.seed,
                                     static_cast<std::uint32_t>(pixel), sample};
            const Ray ray =
                generate_ray(v.camera, pixel % v.camera.width, pixel / v.camera.width,
                             sampler.get_2d(dimension::film), sampler.get_2d(dimension::lens));
            PathRecord record;
            rendered.radiance.push_back(
                lab02::trace_path<F>(v, scene.render, sampler, ray, record));
            rendered.hits.push_back(record.hits);
        }
    return rendered;
}

// The share of samples that differ in a bit; in a build that fuses, in their path.
double differing(const Rendered& a, const Rendered& b) {
    std::size_t differ = 0;
    for (std::size_t i = 0; i < a.radiance.size(); ++i)
        differ += fused ? a.hits[i] != b.hits[i]
                        : std::memcmp(&a.radiance[i], &b.radiance[i], sizeof(Vec3)) != 0;
    return static_cast<double>(differ) / a.radiance.size();
}

class Variants : public testing::TestWithParam<std::string> {};

TEST_P(Variants, GiveTheSameBits) {
    Scene scene = load_scene(find_scene(GetParam()));
    const int side = count(32, 128);
    set_film_size(scene.camera, side, side);
    const Rendered everything = render<variant::everything>(scene);
    const double allowed = fused ? 0.01 : 0;
    const Features features = features_of(scene);
    ASSERT_TRUE(covers(variant::classic, features));
    EXPECT_LE(differing(render<variant::classic>(scene), everything), allowed);
    if (covers(variant::matte, features)) {
        EXPECT_LE(differing(render<variant::matte>(scene), everything), allowed);
    } else {
        // The comparison can fail: a variant that does not cover the scene misses shapes.
        EXPECT_GT(differing(render<variant::matte>(scene), everything), 0.05);
    }
    // And the lab runs what was compared here.
    const Traced traced = trace("02", scene, 2);
    std::size_t other_path = 0;
    for (std::size_t i = 0; i < everything.hits.size(); ++i)
        other_path += traced.records[i % 2 * side * side + i / 2].hits != everything.hits[i];
    EXPECT_LE(1.0 * other_path / everything.hits.size(), allowed);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Variants,
                         testing::Values("cornell_peers", "form_factor", "cornell_spheres",
                                         "point_in_sphere", "soft_shadow", "glass_pane",
                                         "chord_furnace"),
                         [](const auto& info) { return info.param; });

} // namespace

} // namespace raylab::app
