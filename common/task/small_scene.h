// Scenes written in a task's test, as the blocks of a scene file, and many samples of a number.
#pragma once

#include "common/load/load.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace raylab::task {

// The blocks of a scene file (scenes/README.md) that a test chooses; the rest stays as it is here.
struct SceneText {
    std::string materials, shapes;
    std::string lights = "";
    std::string render = R"("max_depth": 2, "spp": 1)";
    std::string camera =
        R"("position": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 40)";
    int width = 16, height = 16;
};

inline Scene small_scene(const SceneText& text) {
    return parse_scene(
        fmt::format(R"({{"version": 1, "title": "test", "reason": "test", "camera": {{{}}},
                        "film": {{"width": {}, "height": {}}}, "render": {{{}}},
                        "materials": {{{}}}, "shapes": [{}], "lights": [{}]}})",
                    text.camera, text.width, text.height, text.render, text.materials, text.shapes,
                    text.lights),
        "small_scene.json");
}

// Mean of many samples and its standard error. A test that allows 4.5 of them gives a false alarm
// once in 147,000 runs of it with other seeds; seeds are fixed, so a verdict stays what it is.
class Samples {
  public:
    void add(double x) { ++n_, sum_ += x, squares_ += x * x; }
    double mean() const { return sum_ / n_; }
    double error() const {
        return std::sqrt(std::fmax(squares_ / n_ - mean() * mean(), 0) / (n_ - 1));
    }
    static constexpr double allowed = 4.5;

  private:
    double n_ = 0, sum_ = 0, squares_ = 0;
};

} // namespace raylab::task
