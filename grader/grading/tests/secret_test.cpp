// What a submission must not know: the key, and the scenes that follow from it.
#include "grader/grading/hidden_scene.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <unistd.h>

namespace raylab::grading {
namespace {

namespace fs = std::filesystem;

std::string hex(const std::string& bytes) {
    std::string text;
    for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
    return text;
}

// RFC 4231, test case 2.
TEST(Secret, TheKeyedHashIsTheStandards) {
    EXPECT_EQ(hex(hmac("Jefe", "what do ya want for nothing?")),
              "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
}

TEST(Secret, TheKeyIsMadeOnceAndForItsOwnerAlone) {
    const fs::path file = fs::path(testing::TempDir()) / fmt::format("key-{}", getpid());
    const std::string key = read_key(file);
    EXPECT_EQ(key.size(), 32u);
    EXPECT_EQ(read_key(file), key);
    EXPECT_EQ(fs::status(file).permissions(), fs::perms(0600));
    fs::permissions(file, fs::perms(0644));
    EXPECT_THROW(read_key(file), std::runtime_error);
    fs::remove(file);
}

const std::string room = R"({"version": 1, "title": "room",
    "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0]}, "film": {"width": 8, "height": 8},
    "render": {"spp": 4}, "materials": {"wall": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]}},
    "shapes": [{"kind": "mesh", "file": "meshes/a.obj", "material": "wall"}]})";

TEST(HiddenScene, FollowsFromKeyAndSubmission) {
    const auto made = [](const std::string& key, const std::string& submission) {
        Derived numbers(key, submission);
        return hidden_scene(room, "/scenes", true, numbers);
    };
    EXPECT_EQ(made("key", "ada"), made("key", "ada"));
    EXPECT_NE(made("key", "ada"), made("key", "bob"));
    EXPECT_NE(made("key", "ada"), made("other", "ada"));
    const auto scene = nlohmann::json::parse(made("key", "ada"));
    const double x = scene["camera"]["position"][0];
    EXPECT_NE(x, 0);
    EXPECT_LE(std::abs(x), .03 * 5);
    for (const double reflectance : scene["materials"]["wall"]["reflectance"]) {
        EXPECT_LE(reflectance, .5);
        EXPECT_GE(reflectance, .35);
    }
    EXPECT_EQ(scene["shapes"][0]["file"], "/scenes/meshes/a.obj");
}

} // namespace
} // namespace raylab::grading
