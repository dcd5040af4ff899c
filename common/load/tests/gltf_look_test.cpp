// The materials of glTF files: the right raylab material for each kind, and the effect of textures
// that raylab's materials do not have.
#include "common/load/gltf_material.h"
#include "common/load/tests/gltf_maker.h"
#include "common/material/fresnel.h"

#include <cmath>

namespace raylab {
namespace {

Scene scene_with(const std::string& material, const std::string& rest = "") {
    return load_made(triangle_file(one_triangle(), "", material, rest));
}

Material material_of(const Scene& scene, std::size_t triangle = 0) {
    return scene.materials[std::size_t(scene.triangles.at(triangle).tags.material)];
}

void expect_near(Vec3 a, Vec3 b, float tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance);
}

double area(const Scene& scene) {
    double sum = 0;
    for (const Triangle& t : scene.triangles) {
        const DVec3 n = cross(DVec3(t.v[1]) - DVec3(t.v[0]), DVec3(t.v[2]) - DVec3(t.v[0]));
        sum += std::sqrt(dot(n, n)) / 2;
    }
    return sum;
}

// A texture made of the image, with a sampler.
std::string texture_of(GltfMaker& maker, const std::string& image,
                       const std::string& sampler = "{}") {
    return R"("textures":[{"source":0,"sampler":0}],"samplers":[)" + sampler +
           R"(],"images":[{"mimeType":"image/png","bufferView":)" +
           std::to_string(maker.view(image)) + "}]";
}

TEST(GltfLook, VertexColoursOfEveryTypeMultiplyTheReflectance) {
    const std::string rough =
        R"("pbrMetallicRoughness":{"baseColorFactor":[0.5,1,1,1],"metallicFactor":0})";
    GltfMaker floats = one_triangle(), bytes = one_triangle(), shorts = one_triangle();
    floats.floats("VEC3", {1, 0.25f, 0, 0, 1, 0, 0, 0, 1});
    bytes.accessor("VEC4", 5121, 3, std::string("\xff\x40\0\xff\0\xff\0\xff\0\0\xff\xff", 12),
                   "\"normalized\":true");
    shorts.accessor("VEC3", 5123, 3,
                    std::string("\xff\xff\0\x40\0\0\0\0\xff\xff\0\0\0\0\0\0\xff\xff", 18),
                    "\"normalized\":true");
    for (const GltfMaker* maker : {&floats, &bytes, &shorts}) {
        const Scene scene = load_made(triangle_file(*maker, ",\"COLOR_0\":2", rough));
        ASSERT_EQ(scene.corner_colours.size(), 1u);
        expect_near(scene.corner_colours[0].factor[0], Vec3(1, 0.25f, 0), 1e-3f);
        EXPECT_EQ(scene.corner_colours[0].factor[1], Vec3(0, 1, 0));
        EXPECT_EQ(scene.corner_colours[0].factor[2], Vec3(0, 0, 1));
        EXPECT_EQ(scene.corners.at(std::size_t(scene.triangles[0].corners)).colours, 0);
        expect_near(material_of(scene).reflectance, Vec3(0.52f, 1, 1), 1e-6f); // with its coat
    }
    EXPECT_TRUE(
        load_made(triangle_file(floats, ",\"COLOR_0\":2", rough), R"(, "material": "white")")
            .corner_colours.empty())
        << "the scene's material replaces all of the file's look";
}

TEST(GltfLook, EmissionHasAStrengthAndMakesLights) {
    const Scene scene = scene_with(
        R"("emissiveFactor":[1,0.5,0.25],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":8}})");
    EXPECT_EQ(material_of(scene).emission, Vec3(8, 4, 2));
    ASSERT_EQ(scene.lights.size(), 2u); // the scene has a point light
    EXPECT_EQ(scene.lights[0].kind, LightKind::triangle);
}

TEST(GltfLook, MetalsReflectTheirBaseColour) {
    const Material m = material_of(scene_with(
        R"("pbrMetallicRoughness":{"baseColorFactor":[1,0.75,0.25,1],"roughnessFactor":0.5})"));
    EXPECT_EQ(m.kind, MaterialKind::conductor);
    EXPECT_FLOAT_EQ(m.alpha, 0.25f);
    expect_near(conductor_reflectance(m, 1), Vec3(1, 0.75f, 0.25f), 2e-4f);
    // Schlick, as the standard has it: f0 + (1 - f0) (1 - cos)^5
    expect_near(conductor_reflectance(m, 0.5f), Vec3(1, 0.7578125f, 0.2734375f), 2e-4f);
}

TEST(GltfLook, OthersAreDiffuseBelowAHighlight) {
    const auto with_roughness = [](const std::string& roughness) {
        return material_of(scene_with(
            R"("pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1],"metallicFactor":0,"roughnessFactor":)" +
            roughness + "}"));
    };
    EXPECT_EQ(with_roughness("1").kind, MaterialKind::diffuse);
    EXPECT_LT(length(with_roughness("1").reflectance - Vec3(0.52f, 0.28f, 1)), 1e-6f);
    const Material m = with_roughness("0.5");
    EXPECT_EQ(m.kind, MaterialKind::phong);
    expect_near(m.specular, Vec3(0.04f), 1e-6f);
    expect_near(m.reflectance, Vec3(0.48f, 0.24f, 0.96f), 1e-6f);
    EXPECT_FLOAT_EQ(m.exponent, 7.5f); // (2 / .25^2 - 2) / 4
    EXPECT_LE(max_component(m.reflectance + m.specular), 1.0f);
}

TEST(GltfLook, AFileWithoutMaterialsHasTheStandardsDefault) {
    GltfMaker maker = one_triangle();
    const Scene scene = load_made(maker.gltf(
        R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])"));
    const Material m = material_of(scene); // white, metallic 1, roughness 1
    EXPECT_EQ(m.kind, MaterialKind::conductor);
    EXPECT_EQ(m.alpha, 1);
    expect_near(conductor_reflectance(m, 1), Vec3(1), 2e-4f);
}

TEST(GltfLook, TransmissionIsGlass) {
    const auto glass = [](const std::string& roughness, const std::string& transmission) {
        return material_of(scene_with(
            R"("pbrMetallicRoughness":{"baseColorFactor":[1,0.5,1,1],"metallicFactor":0,"roughnessFactor":)" +
            roughness + R"(},"extensions":{"KHR_materials_ior":{"ior":1.33},
            "KHR_materials_transmission":{"transmissionFactor":)" +
            transmission + "}}"));
    };
    EXPECT_EQ(glass("0", "1").kind, MaterialKind::glass);
    EXPECT_EQ(glass("0", "1").ior, 1.33f);
    EXPECT_EQ(glass("0", "1").reflectance, Vec3(1, 0.5f, 1));
    EXPECT_EQ(glass("0.5", "1").kind, MaterialKind::rough_dielectric);
    EXPECT_EQ(glass("0.5", "1").alpha, 0.25f);
    EXPECT_EQ(glass("0", "0.25").kind, MaterialKind::phong);
    expect_near(glass("0", "0.25").specular, Vec3(0.020059f), 1e-5f); // (.33 / 2.33)^2
}

TEST(GltfLook, OldSpecularGlossinessIsRead) {
    const Material m = material_of(scene_with(
        R"("extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0.5,0.5,0.25,1],"specularFactor":[0.5,0.5,0.5],"glossinessFactor":0.5}})"));
    EXPECT_EQ(m.kind, MaterialKind::phong);
    EXPECT_EQ(m.specular, Vec3(0.5f));
    EXPECT_EQ(m.reflectance, Vec3(0.25f, 0.25f, 0.125f));
}

const std::string base_texture =
    R"("pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}})";

TEST(GltfLook, TexturesWrapAsTheirSamplersSay) {
    GltfMaker maker = one_triangle();
    const std::string rest =
        texture_of(maker, png(1, 1, "abc"), R"({"wrapS":33071,"wrapT":33648})");
    const Scene scene = load_made(triangle_file(maker, "", base_texture, rest));
    EXPECT_EQ(scene.textures.at(0).wrap_u, Wrap::clamp);
    EXPECT_EQ(scene.textures[0].wrap_v, Wrap::mirror);
    GltfMaker plain = one_triangle();
    const std::string repeats = texture_of(plain, png(1, 1, "abc"));
    EXPECT_EQ(load_made(triangle_file(plain, "", base_texture, repeats)).textures.at(0).wrap_u,
              Wrap::repeat);
}

TEST(GltfLook, TextureTransformsMoveTheTextureCoordinates) {
    const auto uvs = [](const std::string& transform) {
        GltfMaker maker = one_triangle();
        const std::string rest = texture_of(maker, png(1, 1, "abc"));
        const Mesh mesh = parse_made(triangle_file(
            maker, "",
            with(base_texture, "\"index\":0",
                 R"("index":0,"extensions":{"KHR_texture_transform":{)" + transform + "}}"),
            rest));
        std::array<Vec2, 3> uv; // v down, as in the file
        for (int i = 0; i < 3; ++i) {
            const Vec2 up = mesh.uvs[std::size_t(mesh.triangles.at(0).uv[std::size_t(i)])];
            uv[std::size_t(i)] = Vec2(up.x, 1 - up.y);
        }
        return uv;
    };
    const auto moved = uvs(R"("offset":[0.25,0.5],"scale":[2,4])");
    EXPECT_EQ(moved[0], Vec2(0.25f, 0.5f));
    EXPECT_EQ(moved[1], Vec2(2.25f, 0.5f));
    EXPECT_EQ(moved[2], Vec2(0.25f, 4.5f));
    // A quarter turn counterclockwise: u goes up, which is -v; v, which points down, goes to u.
    const auto turned = uvs(R"("rotation":1.5707963267948966)");
    EXPECT_NEAR(turned[1].x, 0, 1e-6);
    EXPECT_NEAR(turned[1].y, -1, 1e-6);
    EXPECT_NEAR(turned[2].x, 1, 1e-6);
    EXPECT_NEAR(turned[2].y, 0, 1e-6);
}

TEST(GltfLook, AlphaBelowTheCutoffIsCutOut) {
    const std::string mask = R"("alphaMode":"MASK",)" + base_texture;
    // Left half there, right half not; an edge half way between the texels' middles, u = 1/2.
    const auto cut = [&](int width, const std::string& rgba, const std::string& material) {
        GltfMaker maker = one_triangle();
        const std::string rest =
            texture_of(maker, png(width, 1, rgba, 4), R"({"wrapS":33071,"wrapT":33071})");
        return load_made(triangle_file(maker, "", material, rest));
    };
    const std::string half("abc\xff"
                           "abc\0",
                           8);
    // The triangle's part with u < 1/2 has 3/4 of its area, 1/2. Pieces are at least 1/4096.
    EXPECT_NEAR(area(cut(2, half, mask)), 0.375, 0.01);
    EXPECT_EQ(cut(2, half, base_texture).triangles.size(), 1u) << "OPAQUE has no alpha";
    const std::string all("abc\x80", 4);
    EXPECT_EQ(cut(1, all, mask).triangles.size(), 1u) << ".502 is above one half";
    const std::string cutoff = with(mask, "\"MASK\"", R"("MASK","alphaCutoff":0.51)");
    EXPECT_NE(error_of([&] { cut(1, all, cutoff); }).find("found none: alpha cuts all 1 out"),
              std::string::npos);
    // The pieces have the texture's coordinates and lie in the triangle's plane.
    for (const Triangle& t : cut(2, half, mask).triangles)
        for (const Vec3& v : t.v) EXPECT_LE(v.x, 0.52f);
    // A constant below the cutoff takes the whole primitive.
    EXPECT_NE(
        error_of([&] {
            scene_with(
                R"("alphaMode":"MASK","pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.25]})");
        }).find("expected triangles in its scene"),
        std::string::npos);
}

// Two triangles over the left and the right half of a picture of two texels.
std::string two_halves(const std::string& image, const std::string& material) {
    GltfMaker maker;
    maker.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 3, 0, 0, 2, 1, 0});
    maker.floats("VEC2", {0, 0, 0.49f, 0, 0, 1, 0.51f, 0, 1, 0, 0.51f, 1});
    const std::string rest = texture_of(maker, image);
    return triangle_file(maker, "", material, rest);
}

TEST(GltfLook, MetallicRoughnessTexturesChooseTheMaterialOfEachTriangle) {
    // Green is roughness, blue is metallic: a half rough metal, and a rough non-metal.
    const Scene scene =
        load_made(two_halves(png(2, 1, std::string("\0\x80\xff\0\xff\0", 6)),
                             R"("pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}})"));
    EXPECT_EQ(material_of(scene, 0).kind, MaterialKind::conductor);
    EXPECT_NEAR(material_of(scene, 0).alpha, 0.25, 1e-6);
    EXPECT_EQ(material_of(scene, 1).kind, MaterialKind::diffuse);
}

TEST(GltfLook, EmissiveTexturesGlowWhereTheyAreNotBlack) {
    const Scene scene =
        load_made(two_halves(png(2, 1, std::string("\0\0\0\xff\xff\0", 6)),
                             R"("emissiveFactor":[1,0.5,1],"emissiveTexture":{"index":0},
                   "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":4}})"));
    EXPECT_EQ(material_of(scene, 0).emission, Vec3(0));
    EXPECT_EQ(material_of(scene, 1).emission, Vec3(4, 2, 0));
    EXPECT_EQ(scene.triangles[0].tags.light, -1);
    EXPECT_EQ(scene.triangles[1].tags.light, 0);
}

TEST(GltfLook, PointLightsShineIfTheSceneWantsThem) {
    const std::string file = one_triangle().gltf(
        R"("nodes":[{"mesh":0},{"translation":[1,2,3],"extensions":{"KHR_lights_punctual":{"light":0}}}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","color":[1,0.5,0.25],"intensity":40}]}})");
    const Scene scene = load_made(file, R"(, "lights": true, "transform": {"scale": 2})");
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[0].kind, LightKind::point);
    EXPECT_EQ(scene.lights[0].position, Vec3(2, 4, 6));
    EXPECT_EQ(scene.lights[0].intensity, Vec3(40, 20, 10));
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(load_made(file, R"(, "lights": false)").lights.size(), 1u);
    EXPECT_TRUE(load_made(file, R"(, "lights": false)").warnings.empty());
    ASSERT_EQ(load_made(file).warnings.size(), 1u);
    EXPECT_NE(load_made(file).warnings[0].find("1 point lights are left out; \"lights\": true"),
              std::string::npos);
}

TEST(GltfLook, OneWarningListsWhatIsLost) {
    GltfMaker maker = one_triangle();
    const std::string rest =
        texture_of(maker, png(1, 1, "abc"), R"({"magFilter":9728})") +
        R"(,"animations":[{},{}],"extensionsUsed":["KHR_materials_clearcoat","KHR_materials_variants","KHR_texture_transform","MSFT_lod"])";
    const std::string material =
        base_texture +
        R"(,"normalTexture":{"index":0},"alphaMode":"BLEND","extensions":{"KHR_materials_clearcoat":{}})";
    const std::string file = triangle_file(maker, "", material, rest);
    const std::vector<std::string> warnings = load_made(file).warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find(
                  "m.gltf: read without KHR_materials_clearcoat (1 material), "
                  "KHR_materials_variants (1 extension), MSFT_lod (1 extension), animations: "
                  "everything is in its rest pose (2 animations), blending "
                  "by alpha, which is cut at one half (1 material), nearest-texel filters (1 "
                  "texture), normal maps (1 material); see docs/formats.md"),
              std::string::npos)
        << warnings[0];
    // If the scene replaces the materials, nothing is lost by not reading the file's.
    const std::vector<std::string> own = load_made(file, R"(, "material": "white")").warnings;
    ASSERT_EQ(own.size(), 1u);
    EXPECT_NE(own[0].find("read without MSFT_lod (1 extension), animations"), std::string::npos);
}

TEST(GltfLook, ImageNamesArePercentDecoded) {
    std::string asked;
    const Mesh mesh = parse_gltf(
        triangle_file(one_triangle(), "", base_texture,
                      R"("textures":[{"source":0}],"images":[{"uri":"a%20b%2Bc%.png"}])"),
        "m.gltf", [&](const std::string& name) {
            asked = name;
            return png(1, 1, "abc");
        });
    EXPECT_EQ(asked, "a b+c%.png");
    EXPECT_EQ(mesh.pictures.size(), 1u);
}

TEST(GltfLook, ATextureWithoutCoordinatesShowsOnePlace) {
    GltfMaker maker = one_triangle();
    const std::string rest = texture_of(maker, png(1, 1, "abc"));
    const Scene scene = load_made(triangle_file(
        maker, "", with(base_texture, "\"index\":0", "\"index\":0,\"texCoord\":3"), rest));
    EXPECT_EQ(scene.corners.at(0).uv[1], Vec2(0, 1));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("texture coordinates that a texture needs (1 primitive)"),
              std::string::npos);
}

TEST(GltfLook, ApproximationsAreSentences) {
    for (const std::string& sentence : gltf_approximations()) EXPECT_EQ(sentence.back(), '.');
    EXPECT_GE(gltf_approximations().size(), 8u);
}

} // namespace
} // namespace raylab
