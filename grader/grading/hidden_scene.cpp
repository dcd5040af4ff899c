#include "grader/grading/hidden_scene.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace raylab::grading {

namespace {

using json = nlohmann::ordered_json;

constexpr int film_side = 96;

// Meshes and pictures, wherever the scene names one.
void name_in_full(json& value, const std::filesystem::path& folder) {
    if (value.is_structured())
        for (json& member : value) name_in_full(member, folder);
    if (!value.is_string()) return;
    const std::filesystem::path file = value.get<std::string>();
    for (const char* ending : {".obj", ".gltf", ".glb", ".png", ".jpg", ".hdr"})
        if (file.extension() == ending) value = (folder / file).string();
}

json graded(const std::string& scene_file, const std::filesystem::path& folder, bool roulette) {
    json scene = json::parse(scene_file);
    name_in_full(scene, folder);
    scene["title"] = "graded";
    scene["film"] = {{"width", film_side}, {"height", film_side}};
    if (!roulette) scene["render"]["roulette"] = false;
    scene.erase("expect");
    return scene;
}

void scale(json& colour, double low, double high, Derived& numbers) {
    if (!colour.is_array()) return;
    for (json& channel : colour)
        if (channel.is_number()) channel = channel.get<double>() * numbers.uniform(low, high);
}

void move_camera(json& camera, Derived& numbers) {
    json& position = camera.at("position");
    const json& target = camera.at("look_at");
    double squared = 0;
    for (int i = 0; i < 3; ++i)
        squared += std::pow(position[i].get<double>() - target[i].get<double>(), 2);
    const double reach = .03 * std::sqrt(squared);
    for (int i = 0; i < 3; ++i)
        position[i] = position[i].get<double>() + numbers.uniform(-reach, reach);
}

} // namespace

std::string public_scene(const std::string& scene_file, const std::filesystem::path& folder,
                         bool roulette) {
    return graded(scene_file, folder, roulette).dump(1);
}

std::string hidden_scene(const std::string& scene_file, const std::filesystem::path& folder,
                         bool roulette, Derived& numbers) {
    json scene = graded(scene_file, folder, roulette);
    move_camera(scene.at("camera"), numbers);
    for (json& material : scene.at("materials")) {
        if (material.contains("reflectance")) scale(material["reflectance"], .7, 1, numbers);
        if (material.contains("emission")) scale(material["emission"], .6, 1.5, numbers);
    }
    if (scene.contains("lights"))
        for (json& light : scene["lights"])
            for (const char* strength : {"radiance", "intensity", "irradiance"})
                if (light.contains(strength)) scale(light[strength], .6, 1.5, numbers);
    return scene.dump(1);
}

} // namespace raylab::grading
