// Judgements as JSON, for results.json and `--json`. Numbers that are not finite become null.
#pragma once

#include "grader/judge/compare.h"
#include "grader/judge/exact.h"
#include "grader/judge/independent.h"
#include "grader/judge/same_paths.h"

#include <nlohmann/json_fwd.hpp>

namespace raylab {

void to_json(nlohmann::json& json, const Verdict& verdict);
void to_json(nlohmann::json& json, const Soundness& soundness);
void to_json(nlohmann::json& json, const SamePathsResult& result);
void to_json(nlohmann::json& json, const ExactResult& result);
void to_json(nlohmann::json& json, const IndependentResult& result);
void to_json(nlohmann::json& json, const Comparison& comparison);
void to_json(nlohmann::json& json, const Metrics& metrics);
void to_json(nlohmann::json& json, const Region& region);

} // namespace raylab
