// Cells and heads of a page's tables, from what the bench's JSON holds.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace raylab::bench::html {

constexpr const char* unknown = "&ndash;";

// Four digits are more than any of a bench's figures can bear.
std::string digits(double v);

std::string text(const nlohmann::ordered_json& value); // a string, escaped

// The median over its interval, an end of which may be open.
std::string measured(const nlohmann::ordered_json& m, const char* prefix = "");

std::string cell(const std::string& content); // <td> of a figure

// <thead> of columns and what they mean; all but the first hold figures.
std::string head(const std::vector<std::pair<const char*, const char*>>& columns);

} // namespace raylab::bench::html
