// What the JSON of several benches has. Figures that are not known become null.
#pragma once

#include "grader/bench/machine.h"
#include "grader/bench/statistics.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace raylab::bench {

nlohmann::ordered_json number(double value);

// {"median", "low", "high", "rounds"}; nothing becomes null.
nlohmann::ordered_json to_json(const Measured& m);
nlohmann::ordered_json to_json(const std::optional<Measured>& m);

nlohmann::ordered_json to_json(const Machine& m);

} // namespace raylab::bench
