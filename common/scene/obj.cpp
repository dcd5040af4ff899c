#include "common/scene/mesh.h"
namespace raylab {
Mesh parse_obj(std::string_view, const std::string&) { return {}; }
} // namespace raylab
