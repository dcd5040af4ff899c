// bench.json: everything, also the values of the single rounds, so that a later run can be compared
// with this one.
#include "grader/bench/bench.h"
#include "grader/bench/json_parts.h"
#include "grader/bench/page.h"

#include "common/cli/files.h"

namespace raylab::bench {

using nlohmann::ordered_json;

namespace {

ordered_json to_json(const Row& row) {
    ordered_json json = {{"name", row.name}, {"title", row.title}};
    if (!row.failure.empty()) {
        json["failure"] = row.failure;
        return json;
    }
    json.update({{"baseline", row.is_baseline},
                 {"agrees", row.agrees},
                 {"verdict", row.verdict},
                 {"remarks", row.remarks},
                 {"ms_per_spp", to_json(row.ms_per_spp)},
                 {"start_up_seconds", to_json(row.start_up)},
                 {"mse", to_json(row.mse)},
                 {"rel_mse", to_json(row.rel_mse)},
                 {"efficiency", to_json(row.efficiency)},
                 {"exponent", to_json(row.exponent)},
                 {"seconds_to_target", to_json(row.seconds_to_target)},
                 {"bias",
                  {{"relative", number(row.bias.relative)},
                   {"half_width_95", number(row.bias.half_width_95)}}},
                 {"speed_ratio", to_json(row.speed_ratio)},
                 {"efficiency_ratio", to_json(row.efficiency_ratio)},
                 {"rays_per_second", number(row.rays_per_second)},
                 {"bytes_per_path", number(row.bytes_per_path)}});
    json["points"] = ordered_json::array();
    for (const ErrorPoint& p : row.points)
        json["points"].push_back({{"spp", p.spp},
                                  {"seconds", number(p.seconds)},
                                  {"rel_mse", number(p.rel_mse)},
                                  {"mse", number(p.mse)}});
    json["bounces"] = ordered_json::array();
    for (const BouncePoint& p : row.bounces)
        json["bounces"].push_back(
            {{"paths_share", p.paths_share},
             {"lanes_share", p.lanes_share ? number(*p.lanes_share) : ordered_json(nullptr)}});
    return json;
}

ordered_json to_json(const Comparison& c) {
    ordered_json changes = ordered_json::array();
    for (const Change& change : c.changes)
        changes.push_back({{"scene", change.scene},
                           {"contestant", change.contestant},
                           {"quantity", change.quantity},
                           {"formed", change.formed},
                           {"ratio", number(change.ratio.median)},
                           {"low", number(change.ratio.low)},
                           {"high", number(change.ratio.high)},
                           {"coverage", change.ratio.coverage},
                           {"verdict", change.verdict}});
    return {{"file", c.file}, {"commit", c.commit}, {"changes", changes}, {"notes", c.notes}};
}

} // namespace

ordered_json to_json(const Bench& bench) {
    const Plan& plan = bench.options.plan;
    ordered_json json = {{"kind", "raylab bench"},
                         {"version", 1},
                         {"command", bench.command},
                         {"machine", to_json(bench.machine)},
                         {"threads", bench.threads},
                         {"rounds", plan.rounds},
                         {"spp", plan.spp},
                         {"first_seed", plan.first_seed},
                         {"baseline", bench.options.baseline},
                         {"target_rel_mse", bench.options.target_rel_mse},
                         {"interval_coverage", interval_coverage(plan.rounds)},
                         {"notes", bench.notes}};
    json["scenes"] = ordered_json::array();
    for (const SceneResult& scene : bench.scenes) {
        ordered_json rows = ordered_json::array();
        for (const Row& row : scene.rows) rows.push_back(to_json(row));
        json["scenes"].push_back({{"name", scene.name},
                                  {"title", scene.title},
                                  {"hash", scene.hash},
                                  {"width", scene.width},
                                  {"height", scene.height},
                                  {"max_depth", scene.max_depth},
                                  {"truth", scene.truth},
                                  {"rows", rows}});
    }
    if (bench.against) json["against"] = to_json(*bench.against);
    if (!bench.rare_cases.empty()) json["rare_cases"] = to_json(bench.rare_cases);
    return json;
}

void write_bench(const Bench& bench, const std::string& folder) {
    // The output of a peer may not be valid UTF-8: its wrong bytes are replaced, and nothing fails.
    const auto json = to_json(bench);
    write_file(folder + "/bench.json",
               json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
    write_file(folder + "/bench.csv", to_csv(bench));
    if (!bench.rare_cases.empty()) write_file(folder + "/rare_cases.csv", to_csv(bench.rare_cases));
    write_file(folder + "/bench.html", page_html(json, to_string(bench.machine)));
}

} // namespace raylab::bench
