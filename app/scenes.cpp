// raylab scenes: what is bundled, and why.
#include "app/commands.h"
#include "common/load/load.h"
#include "common/scene/scene_features.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace raylab::app {

namespace {

ExitCode run_scenes(bool json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const std::string& name : bundled_scenes()) {
        const Scene scene = load_scene(find_scene(name));
        list.push_back({{"name", name},
                        {"title", scene.title},
                        {"reason", scene.reason},
                        {"hash", scene.hash},
                        {"features", feature_names(features_of(scene))},
                        {"closed_forms", scene.expect.size()}});
        if (!json) fmt::print("{:20} {}\n{:20} {}\n", name, scene.title, "", scene.reason);
    }
    if (json) fmt::print("{}\n", list.dump(2));
    return ExitCode::success;
}

} // namespace

Run add_scenes(CLI::App& app) {
    auto json = std::make_shared<bool>(false);
    app.description("List the bundled scenes and why each is there.");
    app.add_flag("--json", *json, "for programs");
    app.footer("Examples:\n  raylab scenes\n  raylab scenes --json");
    return [json] { return run_scenes(*json); };
}

} // namespace raylab::app
