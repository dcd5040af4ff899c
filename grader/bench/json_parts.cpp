#include "grader/bench/json_parts.h"

#include <cmath>

namespace raylab::bench {

using nlohmann::ordered_json;

ordered_json number(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json to_json(const Measured& m) {
    ordered_json rounds = ordered_json::array();
    for (const double value : m.rounds) rounds.push_back(number(value));
    return {{"median", number(m.median)},
            {"low", number(m.low)},
            {"high", number(m.high)},
            {"rounds", rounds}};
}

ordered_json to_json(const std::optional<Measured>& m) {
    return m ? to_json(*m) : ordered_json(nullptr);
}

ordered_json to_json(const Machine& m) {
    return {{"date", m.date},     {"cpu", m.cpu},           {"cores", m.cores},
            {"load", m.load},     {"compiler", m.compiler}, {"flags", m.flags},
            {"commit", m.commit}, {"changed", m.changed}};
}

} // namespace raylab::bench
