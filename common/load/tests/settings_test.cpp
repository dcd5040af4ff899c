// Limits of a render, and the schema's and the loader's agreement on the keys.
#include "common/load/keys.h"
#include "common/load/procedural/procedural.h"
#include "common/load/tests/scene_files.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <set>

namespace raylab {
namespace {

std::string wrong_key(RenderSettings settings, int width, int height) {
    const auto problem = problem_with(settings, width, height);
    return problem ? problem->key : "";
}

TEST(Settings, AreCheckedAtTheirLimits) {
    EXPECT_EQ(wrong_key({}, 1, 1), "");
    EXPECT_EQ(wrong_key({}, 16384, 16384), "");
    EXPECT_EQ(wrong_key({}, 0, 1), "width");
    EXPECT_EQ(wrong_key({}, 1, 16385), "height");
    EXPECT_EQ(wrong_key({.spp = 1 << 20}, 1, 1), "");
    EXPECT_EQ(wrong_key({.spp = (1 << 20) + 1}, 1, 1), "spp");
    EXPECT_EQ(wrong_key({.spp = 0}, 1, 1), "spp");
    EXPECT_EQ(wrong_key({.max_depth = 10000}, 1, 1), "");
    EXPECT_EQ(wrong_key({.max_depth = 10001}, 1, 1), "max_depth");
    EXPECT_EQ(wrong_key({.max_depth = 0}, 1, 1), "max_depth");
    EXPECT_EQ(wrong_key({.integrator = Integrator::whitted, .max_depth = 24}, 1, 1), "");
    EXPECT_EQ(wrong_key({.integrator = Integrator::whitted, .max_depth = 25}, 1, 1), "max_depth");
}

TEST(Settings, AreReadAndHaveDefaults) {
    const Scene scene = load(with(good_scene, "\"max_depth\": 8",
                                  R"("max_depth": 3, "seed": 4294967295, "sampler": "independent",
        "direct_light": "bsdf", "roulette": false, "integrator": "whitted", "jitter": false)"));
    EXPECT_EQ(scene.render.max_depth, 3);
    EXPECT_EQ(scene.render.spp, 4);
    EXPECT_EQ(scene.render.seed, 4294967295u);
    EXPECT_EQ(scene.render.sampler, SamplerKind::independent);
    EXPECT_EQ(scene.render.direct_light, DirectLight::bsdf);
    EXPECT_EQ(scene.render.integrator, Integrator::whitted);
    EXPECT_FALSE(scene.render.roulette);
    EXPECT_FALSE(scene.render.jitter);
    const RenderSettings none =
        load(with(good_scene, "  \"render\": {\"spp\": 4, \"max_depth\": 8},\n", "")).render;
    EXPECT_EQ(none.spp, RenderSettings{}.spp);
}

using Keys = std::set<std::string>;

Keys keys_of(const nlohmann::json& schema) {
    Keys keys;
    for (const auto& [key, value] : schema.at("properties").items()) keys.insert(key);
    EXPECT_EQ(schema.at("additionalProperties"), false);
    return keys;
}

TEST(Schema, ListsExactlyTheKeysTheLoaderKnows) {
    std::ifstream file("scenes/scene.schema.json");
    ASSERT_TRUE(file) << "run from the root of the repository";
    const nlohmann::json schema = nlohmann::json::parse(file), &blocks = schema.at("properties");
    std::map<std::string, Keys> listed{
        {"scene", keys_of(schema)},
        {"camera", keys_of(blocks.at("camera"))},
        {"film", keys_of(blocks.at("film"))},
        {"render", keys_of(blocks.at("render"))},
        {"expect", keys_of(blocks.at("expect").at("items"))},
        {"transform", keys_of(schema.at("definitions").at("transform"))},
        {"rotate",
         keys_of(
             schema.at("definitions").at("transform").at("properties").at("rotate").at("items"))}};
    const auto add_kinds = [&](const std::string& of, const nlohmann::json& kinds) {
        for (const nlohmann::json& kind : kinds.at("oneOf"))
            listed[of + " " + kind.at("properties").at("kind").at("const").get<std::string>()] =
                keys_of(kind);
    };
    add_kinds("material", blocks.at("materials").at("additionalProperties"));
    add_kinds("shape", blocks.at("shapes").at("items"));
    add_kinds("light", blocks.at("lights").at("items"));

    std::map<std::string, Keys> known;
    for (const auto& [block, keys] : scene_keys()) known[block] = Keys(keys.begin(), keys.end());
    EXPECT_EQ(listed, known);
    for (const nlohmann::json& kind : blocks.at("shapes").at("items").at("oneOf")) {
        const nlohmann::json& keys = kind.at("properties");
        if (keys.at("kind").at("const") == "procedural") {
            EXPECT_EQ(keys.at("mesh").at("enum"), procedural_mesh_names());
        }
    }
}

} // namespace
} // namespace raylab
