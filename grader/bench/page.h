// bench.html: one self-contained page, made from what bench.json holds. Figures are in its tables;
// the script draws the plots.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace raylab::bench {

// `bench`: as to_json(Bench) makes it; `machine`: one line for people.
std::string page_html(const nlohmann::ordered_json& bench, const std::string& machine);

} // namespace raylab::bench
