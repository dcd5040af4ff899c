#include "grader/bench/rounds.h"

namespace raylab::bench {

std::vector<Turns> take_turns(const std::vector<Contestant>& contestants, const Plan& plan,
                              const std::function<void(int)>& after_run) {
    std::vector<Turns> all;
    for (const Contestant& c : contestants) all.push_back({c.name, c.title, "", {}});
    std::uint32_t seed = plan.first_seed;
    int runs = 0;
    for (int round = 0; round < plan.rounds; ++round) {
        for (Turns& turns : all) turns.drawn.emplace_back();
        for (const int spp : plan.spp)
            for (std::size_t i = 0; i < all.size(); ++i) {
                const std::size_t who = (i + static_cast<std::size_t>(round)) % all.size();
                if (all[who].failure.empty()) try {
                        Drawn drawn = contestants[who].render(spp, seed);
                        drawn.spp = spp;
                        drawn.image.variance = {}; // of no use here, and as large as the image
                        all[who].drawn.back().push_back(std::move(drawn));
                    } catch (const ContestantError& error) {
                        all[who].failure = error.what();
                    }
                ++seed;
                if (after_run) after_run(++runs);
            }
    }
    return all;
}

} // namespace raylab::bench
