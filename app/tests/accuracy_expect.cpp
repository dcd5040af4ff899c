// Every bundled scene keeps what it promises: its `expect` is met. With 10 % more light it would
// not be met.
#include "app/expectation.h"
#include "app/tests/accuracy.h"

namespace raylab::app {

namespace {

constexpr int replicates = 16;

// Rays of one replicate at the scene's present spp. The full check uses the scene's own spp; the
// quick check halves it, and its tolerance grows with the noise.
long long rays_of(const Scene& scene) {
    return 1ll * scene.camera.width * scene.camera.height * scene.render.spp *
           scene.render.max_depth;
}

std::vector<Image> render(const Lab& lab, Scene scene, const Expectation& expectation) {
    scene.render.spp = std::max(expectation.spp, 1);
    const bool in_full = count(0, 1);
    while (!in_full && scene.render.spp > 1 && rays_of(scene) > 40'000) scene.render.spp /= 2;
    const std::unique_ptr<Renderer> renderer = lab.make(scene, {});
    std::vector<Image> images;
    for (int r = 0; r < replicates; ++r)
        images.push_back(
            raylab::render(*renderer, scene, scene.camera, 1000 + r, scene.render.spp).image);
    return images;
}

void brighten(Scene& scene, float factor) {
    for (Material& material : scene.materials) material.emission *= factor;
    for (Light& light : scene.lights) light.intensity *= factor;
    scene.environment_radiance *= factor;
}

std::vector<std::pair<std::string, std::string>> promises() {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const std::string& name : bundled_scenes())
        if (!load_scene(find_scene(name)).expect.empty())
            for (const Lab& lab : labs()) pairs.emplace_back(name, lab.number);
    return pairs;
}

class Expect : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(Expect, IsMet) {
    const auto& [name, number] = GetParam();
    const Scene scene = load_scene(find_scene(name));
    Scene brighter = scene;
    brighten(brighter, 1.1f);
    for (const Expectation& expectation : scene.expect) {
        const Lab& lab = find_lab(number);
        const ExpectationResult result =
            check_expectation(expectation, render(lab, scene, expectation));
        EXPECT_TRUE(result.met) << result.sentence;
        fmt::print("  {} lab {}: {:.8g}, found {:.8g} +- {:.1g}\n", name, number, result.expected,
                   result.value, result.standard_error);
        EXPECT_FALSE(check_expectation(expectation, render(lab, brighter, expectation)).met)
            << "too noisy to see 10 % more light";
    }
}

INSTANTIATE_TEST_SUITE_P(Bundled, Expect, testing::ValuesIn(promises()), [](const auto& info) {
    return info.param.first + "Lab" + info.param.second;
});

} // namespace

} // namespace raylab::app
