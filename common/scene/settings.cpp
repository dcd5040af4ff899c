// The limits of a render, checked in one place.
#include "common/scene/settings.h"

#include <fmt/format.h>

namespace raylab {

std::optional<SettingsProblem> problem_with(const RenderSettings& settings, int width, int height) {
    const auto side = [](const char* key, int pixels) -> std::optional<SettingsProblem> {
        if (pixels >= 1 && pixels <= max_film_side) return std::nullopt;
        return SettingsProblem{
            key, fmt::format("expected 1 to {} pixels, found {}", max_film_side, pixels)};
    };
    if (auto problem = side("width", width)) return problem;
    if (auto problem = side("height", height)) return problem;

    if (settings.spp < 1 || settings.spp > max_samples)
        return SettingsProblem{"spp", fmt::format("expected 1 to {} samples a pixel, found {}",
                                                  max_samples, settings.spp)};

    if (settings.max_depth < 1 || settings.max_depth > max_path_depth)
        return SettingsProblem{"max_depth",
                               fmt::format("expected 1 to {}, found {}; 1 shows only what glows, "
                                           "2 adds direct light",
                                           max_path_depth, settings.max_depth)};
    if (settings.integrator == Integrator::whitted && settings.max_depth > max_whitted_depth)
        return SettingsProblem{
            "max_depth",
            fmt::format(
                "expected 1 to {} with the integrator \"whitted\", whose rays double at each "
                "glass surface, found {}; lower it or use the integrator \"path\"",
                max_whitted_depth, settings.max_depth)};
    return std::nullopt;
}

} // namespace raylab
