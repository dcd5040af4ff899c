#include "labs/04_accel/choose_accel.h"

#include "common/render/renderer.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::lab04 {

namespace {

// "kd: stack, ropes, restart; sah: stack", for a message.
std::string all_walks() {
    std::string text;
    AccelKind last = AccelKind::automatic;
    for (const KnownWalk& known : known_walks()) {
        if (known.walk == WalkKind::automatic) continue;
        text += known.accel == last ? fmt::format(", {}", name_of(known.walk))
                                    : fmt::format("{}{}: {}", text.empty() ? "" : "; ",
                                                  name_of(known.accel), name_of(known.walk));
        last = known.accel;
    }
    return text;
}

} // namespace

AccelChoice choose_accel(int triangles, const AccelSettings& settings) {
    const bool open = settings.accel == AccelKind::automatic;
    const bool few = open && settings.walk == WalkKind::automatic && triangles <= few_triangles;
    const AccelKind accel = few ? AccelKind::none : settings.accel;
    const auto fits = [&](const KnownWalk& known) {
        return (accel == AccelKind::automatic || known.accel == accel) &&
               (settings.walk == WalkKind::automatic || known.walk == settings.walk);
    };
    const auto found = std::find_if(known_walks().begin(), known_walks().end(), fits);
    if (found == known_walks().end())
        throw SettingsError(fmt::format(
            "there is no walk '{}' for --accel {}; the walks are {}{}", name_of(settings.walk),
            name_of(settings.accel), all_walks(),
            accel == AccelKind::none ? ". Without a structure there is nothing to walk" : ""));
    if (!open) return {*found, "asked for"};
    if (few)
        return {*found, fmt::format("as up to {} triangles are tested as fast as a tree is walked",
                                    few_triangles)};
    return {*found, settings.walk == WalkKind::automatic
                        ? fmt::format("the fastest for more than {} triangles", few_triangles)
                        : fmt::format("the fastest with the walk '{}'", name_of(settings.walk))};
}

} // namespace raylab::lab04
