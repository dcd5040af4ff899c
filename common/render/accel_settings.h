// Which structure over the triangles a lab builds, and how rays walk it. No field changes a bit of
// the image.
#pragma once

#include <string>

namespace raylab {

// By the names that the lab gives them (Lab::accels); "auto": what is fastest for the scene.
struct AccelSettings {
    std::string accel = "auto"; // the structure
    std::string walk = "auto";  // how a ray gets back from a subtree

    friend bool operator==(const AccelSettings&, const AccelSettings&) = default;
};

} // namespace raylab
