#include "grader/bench/rounds.h"

namespace raylab::bench {

namespace {

// The render, unless the contestant has failed before or fails now: then nothing.
std::optional<Drawn> draw(const Contestant& contestant, Turns& turns, int spp, std::uint32_t seed) {
    if (!turns.failure.empty()) return {};
    try {
        Drawn drawn = contestant.render(spp, seed);
        drawn.spp = spp;
        drawn.image.error = {}; // of no use here, and as large as the image
        return drawn;
    } catch (const ContestantError& error) {
        turns.failure = error.what();
        return {};
    }
}

} // namespace

std::vector<Turns> take_turns(const std::vector<Contestant>& contestants, const Plan& plan,
                              const std::function<void(int)>& after_run) {
    std::vector<Turns> all;
    for (const Contestant& c : contestants) all.push_back({c.name, c.title, "", {}});
    std::uint32_t seed = plan.first_seed;
    // All draw once untimed. Afterwards, caches on disk are filled and kernels are compiled.
    for (std::size_t who = 0; who < all.size(); ++who)
        draw(contestants[who], all[who], plan.spp.front(), seed++);
    int runs = 0;
    for (int round = 0; round < plan.rounds; ++round) {
        for (Turns& turns : all) turns.drawn.emplace_back();
        for (const int spp : plan.spp)
            for (std::size_t i = 0; i < all.size(); ++i) {
                const std::size_t who = (i + static_cast<std::size_t>(round)) % all.size();
                if (auto drawn = draw(contestants[who], all[who], spp, seed++))
                    all[who].drawn.back().push_back(std::move(*drawn));
                if (after_run) after_run(++runs);
            }
    }
    return all;
}

} // namespace raylab::bench
