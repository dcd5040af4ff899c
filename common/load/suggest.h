// "Did you mean ...?": the known word nearest to a misspelled one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raylab {

// How many letters must be inserted, removed, replaced or swapped with their neighbour to turn a
// into b (optimal string alignment distance).
int edit_distance(std::string_view a, std::string_view b);

// `; did you mean "radius"?`, or nothing if no word is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

// `"a", "b" or "c"`; `nothing` if the list is empty.
std::string one_of(const std::vector<std::string>& words);

std::string listed(const std::vector<std::string>& words); // `a, b, c`

} // namespace raylab
