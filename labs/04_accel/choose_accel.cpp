#include "labs/04_accel/choose_accel.h"

#include "common/render/renderer.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::lab04 {

namespace {

const std::string automatic = AccelSettings{}.walk, no_structure = "none";

// "kd: stack, ropes, restart; sah: stack", for a message.
std::string all_walks() {
    std::string text;
    std::string last;
    for (const KnownWalk& known : known_walks()) {
        if (known.walk == automatic) continue;
        text += known.accel == last
                    ? fmt::format(", {}", known.walk)
                    : fmt::format("{}{}: {}", text.empty() ? "" : "; ", known.accel, known.walk);
        last = known.accel;
    }
    return text;
}

} // namespace

AccelChoice choose_accel(int triangles, const AccelSettings& settings) {
    const bool open = settings.accel == automatic;
    const bool few = open && settings.walk == automatic && triangles <= few_triangles;
    const std::string accel = few ? no_structure : settings.accel;
    const auto fits = [&](const KnownWalk& known) {
        return (accel == automatic || known.accel == accel) &&
               (settings.walk == automatic || known.walk == settings.walk);
    };
    const auto found = std::find_if(known_walks().begin(), known_walks().end(), fits);
    if (found == known_walks().end())
        throw SettingsError(fmt::format(
            "there is no walk '{}' for --accel {}; the walks are {}{}", settings.walk,
            settings.accel, all_walks(),
            accel == no_structure ? ". Without a structure there is nothing to walk" : ""));
    if (!open) return {*found, "asked for"};
    if (few)
        return {*found, fmt::format("as up to {} triangles are tested as fast as a tree is walked",
                                    few_triangles)};
    return {*found, settings.walk == automatic
                        ? fmt::format("the fastest for more than {} triangles", few_triangles)
                        : fmt::format("the fastest with the walk '{}'", settings.walk)};
}

} // namespace raylab::lab04
