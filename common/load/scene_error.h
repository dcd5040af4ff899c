// The error of everything that reads a scene: made to be read by the person who wrote the file.
#pragma once

#include <stdexcept>
#include <string>

namespace raylab {

// what() is `file:line:column: /shapes/3/material: expected ..., found ...; what to do`.
struct SceneError : std::runtime_error {
    explicit SceneError(const std::string& what) : std::runtime_error(what) {}
};

} // namespace raylab
