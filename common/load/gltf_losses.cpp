#include "common/load/gltf_losses.h"

#include <fmt/format.h>

namespace raylab {

std::string GltfLosses::sentence(const std::string& name) const {
    std::string list;
    for (const auto& [loss, count] : count_)
        list += fmt::format("{}{} ({} {}{})", list.empty() ? "" : ", ", loss.first, count,
                            loss.second, count == 1 ? "" : "s");
    return list.empty() ? "" : name + ": read without " + list + "; see docs/formats.md";
}

} // namespace raylab
