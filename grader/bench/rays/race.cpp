#include "grader/bench/rays/race.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab::bench {

namespace {

// A contestant that is still in the race.
struct Runner {
    const RayContestant* contestant;
    RayRow* row;
    std::unique_ptr<RayStructure> structure;
    std::vector<double> build_seconds;
};

// The answers to one kind of rays: t and triangle; for any-hit rays 0, and -1 or 0.
using Answers = std::vector<RayAnswer>;

double trace(const RayStructure& structure, const RaySet& set, Answers& answers) {
    answers.assign(set.rays.size(), {});
    if (!asks_any(set.kind)) return structure.closest(set.rays, answers);
    std::vector<std::uint8_t> blocked(set.rays.size());
    const double seconds = structure.any(set.rays, blocked);
    for (std::size_t i = 0; i < blocked.size(); ++i)
        if (blocked[i]) answers[i] = {0, 0};
    return seconds;
}

bool differ(const RayAnswer& a, const RayAnswer& b, bool exactly) {
    if (exactly) return !(a.t == b.t && a.triangle == b.triangle);
    if ((a.triangle < 0) != (b.triangle < 0)) return true;
    return a.triangle >= 0 && !(std::fabs(a.t - b.t) <= tolerated_t * std::max(a.t, b.t));
}

// All build in turns. A contestant that cannot build is removed from `runners`.
void build_all(std::vector<Runner>& runners, const RayMesh& mesh, const RaceOptions& options,
               const std::function<void()>& after_step) {
    for (int build = 0; build < options.builds; ++build)
        for (std::size_t i = 0; i < runners.size(); ++i) {
            Runner& runner = runners[(i + std::size_t(build)) % runners.size()];
            if (!runner.row->failure.empty()) continue;
            try {
                runner.structure.reset(); // so that two structures are never in memory together
                BuiltStructure built = runner.contestant->build(mesh.triangles, options.threads);
                runner.structure = std::move(built.structure);
                runner.build_seconds.push_back(built.seconds);
                runner.row->bytes_per_triangle = built.bytes / double(mesh.triangles.size());
            } catch (const ContestantError& error) {
                runner.row->failure = error.what();
            }
            if (after_step) after_step();
        }
    std::erase_if(runners, [](const Runner& runner) { return !runner.row->failure.empty(); });
    for (Runner& runner : runners) runner.row->build_seconds = measured(runner.build_seconds);
}

std::optional<RayCounts> counts_a_ray(const RayStructure& structure, const RaySet& set) {
    auto counts =
        asks_any(set.kind) ? structure.count_any(set.rays) : structure.count_closest(set.rays);
    if (counts && !set.rays.empty()) {
        counts->nodes /= double(set.rays.size());
        counts->triangles /= double(set.rays.size());
    }
    return counts;
}

// Some rays of a set, evenly chosen from it, and brute force's answers to them.
struct Verified {
    std::vector<std::size_t> which;
    Answers right;
};

Verified verify(const RaySet& set, const RayMesh& mesh, const RaceOptions& options) {
    Verified result;
    RaySet some = {set.kind, {}};
    const std::size_t count = std::min(set.rays.size(), std::size_t(options.verify));
    for (std::size_t i = 0; i < count; ++i) {
        result.which.push_back(i * set.rays.size() / count);
        some.rays.push_back(set.rays[result.which.back()]);
    }
    trace(*brute_force().build(mesh.triangles, options.threads).structure, some, result.right);
    return result;
}

// Compares one contestant's answers. The rounds fill in the rest of the cell.
RayCell judged(const Runner& runner, const RaySet& set, const Answers& answers,
               const Answers& truth, bool truth_is_exact, const Verified& verified) {
    const bool is_exact = runner.contestant->is_exact;
    RayCell cell;
    cell.kind = set.kind;
    for (std::size_t i = 0; i < answers.size(); ++i)
        cell.differing += differ(answers[i], truth[i], is_exact && truth_is_exact);
    cell.verified = int(verified.which.size());
    for (std::size_t i = 0; i < verified.which.size(); ++i)
        cell.wrong += differ(answers[verified.which[i]], verified.right[i], is_exact);
    const auto tolerated = [&](int count, std::size_t of, bool exactly) {
        return count <= (exactly ? 0 : tolerated_share * double(of));
    };
    cell.agrees = tolerated(cell.differing, answers.size(), is_exact && truth_is_exact) &&
                  tolerated(cell.wrong, verified.which.size(), is_exact);
    cell.a_ray = counts_a_ray(*runner.structure, set);
    return cell;
}

// First all trace once untimed, which gives the answers; then come the rounds.
void race_kind(std::vector<Runner>& runners, std::size_t truth, const RaySet& set,
               const RayMesh& mesh, const RaceOptions& options,
               const std::function<void()>& after_step) {
    Answers right, answers;
    trace(*runners[truth].structure, set, right);
    const Verified verified = verify(set, mesh, options);
    for (Runner& runner : runners) {
        trace(*runner.structure, set, answers);
        runner.row->cells.push_back(
            judged(runner, set, answers, right, runners[truth].contestant->is_exact, verified));
    }
    std::vector<std::vector<double>> mrays(runners.size());
    for (int round = 0; round < options.rounds; ++round)
        for (std::size_t i = 0; i < runners.size(); ++i) {
            const std::size_t who = (i + std::size_t(round)) % runners.size();
            double seconds = 0, rays = 0;
            do {
                seconds += trace(*runners[who].structure, set, answers);
                rays += double(set.rays.size());
            } while (seconds < options.least_seconds && rays > 0);
            mrays[who].push_back(1e-6 * rays / seconds);
            if (after_step) after_step();
        }
    const auto baseline = std::find_if(runners.begin(), runners.end(), [&](const Runner& runner) {
        return runner.contestant->name == options.baseline;
    });
    for (std::size_t who = 0; who < runners.size(); ++who) {
        RayCell& cell = runners[who].row->cells.back();
        cell.mrays = measured(mrays[who]);
        if (baseline == runners.end() || set.rays.empty() || !cell.agrees ||
            !baseline->row->cells.back().agrees)
            continue;
        std::vector<double> ratios;
        const auto& base = mrays[std::size_t(baseline - runners.begin())];
        for (std::size_t r = 0; r < base.size(); ++r) ratios.push_back(mrays[who][r] / base[r]);
        cell.ratio = measured(ratios);
    }
}

} // namespace

int race_steps(const std::vector<RayContestant>& contestants, const RaceOptions& options) {
    return int(contestants.size()) * (options.builds + options.rounds * int(options.kinds.size()));
}

RayRace race(const RayMesh& mesh, const std::vector<RayContestant>& contestants,
             const RaceOptions& options, const std::function<void()>& after_step) {
    RayRace result;
    result.mesh = mesh.name;
    result.left_out = mesh.left_out;
    result.triangles = int(mesh.triangles.size());
    const double tests =
        double(mesh.triangles.size()) * mesh.camera.width * double(mesh.camera.height);
    for (const RayContestant& c : contestants) {
        result.rows.push_back({c.name, c.title, "", c.is_exact, {}, 0, {}});
        if (tests > c.most_tests)
            result.rows.back().failure =
                fmt::format("left out: {} triangles for each of {} x {} rays are too many tests",
                            mesh.triangles.size(), mesh.camera.width, mesh.camera.height);
    }
    std::vector<Runner> runners;
    for (std::size_t i = 0; i < contestants.size(); ++i)
        if (result.rows[i].failure.empty())
            runners.push_back({&contestants[i], &result.rows[i], nullptr, {}});
    build_all(runners, mesh, options, after_step);
    if (runners.empty())
        throw ContestantError(
            fmt::format("nobody can trace {}: {}", mesh.name,
                        result.rows.empty() ? "there are no contestants" : result.rows[0].failure));
    std::size_t truth = 0;
    while (truth < runners.size() && !runners[truth].contestant->is_exact) ++truth;
    if (truth == runners.size()) truth = 0;
    result.truth = runners[truth].contestant->name;

    const std::vector<RaySet> sets = make_ray_sets(mesh, *runners[truth].structure, options.seed);
    for (const RayKind kind : options.kinds) {
        const RaySet& set = sets[std::size_t(kind)];
        result.ray_counts.push_back(int(set.rays.size()));
        race_kind(runners, truth, set, mesh, options, after_step);
    }
    return result;
}

} // namespace raylab::bench
