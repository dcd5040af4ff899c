// What each source file includes, and the order of rooms that docs/architecture.md draws.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace raylab::order {

// A file of the project by its path from the root ("common/math/vec.h"), and the files that it
// includes by such a path. Tests are left out: they may look at any room.
using Includes = std::map<std::string, std::vector<std::string>>;

Includes read_includes(const std::filesystem::path& root);

// The rooms of common from the bottom to the top, as the page lists them: each line of the list
// begins with four spaces and the room's name. Throws std::runtime_error if there is no list.
std::vector<std::string> rooms_from_the_bottom(const std::string& page);

// A sentence for each include that points up: to a room above, or from common, a lab or the grader
// to what must stay unknown there; and one for a room that the list lacks.
std::vector<std::string> upward(const Includes& includes, const std::vector<std::string>& rooms);

// The files of the first circle that is found, in order, with the first file again at the end;
// empty if there is none.
std::vector<std::string> circle(const Includes& includes);

} // namespace raylab::order
