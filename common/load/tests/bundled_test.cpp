// The scenes that come with raylab, and what identifies a scene.
#include "common/image/image_file.h"
#include "common/load/tests/scene_files.h"
#include "common/scene/scene_features.h"

#include <fstream>
#include <sstream>

namespace raylab {
namespace {

TEST(BundledScenes, AllLoadWithoutAWarning) {
    EXPECT_GE(bundled_scenes().size(), 12u);
    for (const std::string& name : bundled_scenes()) {
        SCOPED_TRACE(name);
        const Scene scene = load_scene(find_scene(name));
        EXPECT_EQ(scene.name, name);
        EXPECT_FALSE(scene.reason.empty());
        EXPECT_EQ(scene.warnings, std::vector<std::string>{});
    }
}

TEST(BundledScenes, EachHasARowInTheFoldersReadme) {
    std::stringstream page;
    page << std::ifstream(find_scene("cornell").parent_path() / "README.md").rdbuf();
    for (const std::string& name : bundled_scenes())
        EXPECT_NE(page.str().find("| `" + name + "` |"), std::string::npos) << name;
}

TEST(BundledScenes, AreThoseThatTheirReferencesWereMadeOf) {
    int references = 0;
    for (const std::string& name : bundled_scenes()) {
        const std::filesystem::path file = find_scene(name);
        const std::filesystem::path path = file.parent_path() / "references" / (name + ".exr");
        if (!std::filesystem::exists(path)) continue;
        EXPECT_EQ(read_image(path.string()).provenance.scene_hash, load_scene(file).hash) << name;
        ++references;
    }
    EXPECT_GT(references, 10);
}

TEST(FindScene, TakesNamesAndPathsAndSuggestsTheNearest) {
    TemporaryFolder folder;
    folder.write("mine.json", good_scene);
    EXPECT_EQ(find_scene((folder / "mine.json").string()), folder / "mine.json");
    EXPECT_TRUE(std::filesystem::is_regular_file(find_scene("cornell")));
    EXPECT_NE(error_of([] {
                  find_scene("cornel");
              }).find("there is no scene cornel; did you mean \"cornell\"?"),
              std::string::npos);
    EXPECT_NE(error_of([&] { load_scene(folder / "yours.json"); }).find("there is no file"),
              std::string::npos);
}

TEST(SceneHash, ChangesWithTheSceneAndWithEveryFileItNames) {
    TemporaryFolder folder;
    const std::string scene =
        scene_of_shapes(R"({"kind": "mesh", "file": "m.obj", "material": "lamp"})");
    const auto hash = [&](const std::string& text, const std::string& mesh) {
        folder.write("m.obj", mesh);
        return load(text, folder).hash;
    };
    const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", first = hash(scene, mesh);
    EXPECT_EQ(first.size(), 16u);
    EXPECT_EQ(first.find_first_not_of("0123456789abcdef"), first.npos);
    EXPECT_EQ(hash(scene, mesh), first);
    EXPECT_NE(hash(scene + " ", mesh), first);
    EXPECT_NE(hash(scene, mesh + "#"), first);
}

TEST(Features, AreThoseOfTheShapesTheirMaterialsAndTheLights) {
    EXPECT_EQ(feature_names(features_of(load(good_scene))),
              "sphere quad diffuse area_light point_light");
    const std::string unused =
        with(good_scene, "\"white\": {",
             "\"gold\": {\"kind\": \"mirror\", \"reflectance\": [1, 1, 1]},\n\"white\": {");
    EXPECT_EQ(features_of(load(unused)), features_of(load(good_scene)))
        << "a material no shape has costs nothing";
    const std::string lens =
        with(good_scene, "\"vfov_deg\": 40", "\"vfov_deg\": 40, \"lens_radius\": 0.1");
    EXPECT_EQ(features_of(load(lens)), features_of(load(good_scene)) | feature::lens);
    EXPECT_EQ(feature_names(0), "");
}

TEST(Warnings, TellWhatIsLegalButProbablyNotMeant) {
    const std::string no_light =
        with(with(good_scene, ",\n    {\"kind\": \"quad\"", ",\n {\"kind\": \"quad\""),
             "\"emission\": [1, 1, 1]", "\"emission\": [0, 0, 0]");
    const Scene dark = load(
        with(no_light, "[{\"kind\": \"point\", \"position\": [0, 5, 0], \"intensity\": [1, 1, 1]}]",
             "[]"));
    EXPECT_TRUE(dark.lights.empty());
    ASSERT_EQ(dark.warnings.size(), 1u);
    EXPECT_EQ(dark.warnings[0], "no light and nothing emits: the image will be black; add a light, "
                                "or an emission to a material");

    const Scene empty = load(R"({"version": 1, "film": {"width": 1, "height": 1}, "camera":
        {"position": [0, 0, 0], "look_at": [0, 0, -1], "up": [0, 1, 0], "vfov_deg": 40}})");
    EXPECT_EQ(empty.warnings.size(), 2u); // no shapes, no light
}

TEST(View, ShowsTheScenesOwnArrays) {
    const Scene scene = load(good_scene);
    const SceneView v = view(scene);
    EXPECT_EQ(v.spheres.data, scene.spheres.data());
    EXPECT_EQ(v.quads.size, 1);
    EXPECT_EQ(v.lights.size, 2);
    EXPECT_EQ(v.environment.light, -1);
}

TEST(Expectations, AreRead) {
    const Scene scene = load(with(good_scene, "\"version\": 1,", R"("version": 1, "expect": [
        {"formula": "f", "value": 2, "tolerance": 1e-5, "region": [1, 0, 3, 2], "spp": 16},
        {"formula": "g", "value": [1, 2, 3], "tolerance": 0}],)"));
    ASSERT_EQ(scene.expect.size(), 2u);
    EXPECT_EQ(scene.expect[0].value, Vec3(2));
    EXPECT_EQ(scene.expect[0].spp, 16);
    EXPECT_EQ(scene.expect[0].region, (std::array{1, 0, 3, 2}));
    EXPECT_EQ(scene.expect[1].value, Vec3(1, 2, 3));
    EXPECT_EQ(scene.expect[1].spp, 4) << "the samples of the render block";
    EXPECT_EQ(scene.expect[1].tolerance, 0);
}

} // namespace
} // namespace raylab
