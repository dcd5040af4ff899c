// Scenes that nobody has seen before: a bundled scene with another camera, other colours and
// another light.
#pragma once

#include "grader/grading/secret.h"

namespace raylab::grading {

// The scene file at the size of graded pictures, as text; `roulette` false: switched off. The files
// that it names relative to `folder` are named in full.
std::string public_scene(const std::string& scene_file, const std::filesystem::path& folder,
                         bool roulette);

// The same, changed by numbers that follow from the grader's key and the submission: two
// submissions meet different scenes, one submission the same scene again. The camera moves by up to
// 3 % of its distance, reflectances become .7 to 1 of what they were, each light's colour .6
// to 1.5.
std::string hidden_scene(const std::string& scene_file, const std::filesystem::path& folder,
                         bool roulette, Derived& numbers);

} // namespace raylab::grading
