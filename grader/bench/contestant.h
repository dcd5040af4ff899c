// A contestant of a bench: a program that draws one scene with a number of samples and a seed.
#pragma once

#include "common/film/ledger.h"
#include "common/image/image.h"

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace raylab::bench {

// what() is a sentence for people: what failed, where, what to do. The other contestants go on.
struct ContestantError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// One render.
struct Drawn {
    Image image;                  // the mean alone counts
    int spp = 0;                  // set by take_turns()
    double seconds = 0;           // wall clock, from nothing to the finished image
    std::optional<Ledger> ledger; // where the contestant keeps one
    double bytes = 0;             // memory held for the render, 0: unknown
};

struct Contestant {
    std::string name;  // "02", "cycles"
    std::string title; // "02_iterative", "Blender 3.4.1 Cycles"
    // Renders its scene. Every random number must come from the seed. Throws ContestantError.
    std::function<Drawn(int spp, std::uint32_t seed)> render;
};

} // namespace raylab::bench
