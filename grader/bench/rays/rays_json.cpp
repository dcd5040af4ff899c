// rays.json: everything, also the values of the single rounds.
#include "common/cli/files.h"
#include "grader/bench/json_parts.h"
#include "grader/bench/rays/rays_bench.h"

#include <algorithm>

namespace raylab::bench {

using nlohmann::ordered_json;

namespace {

ordered_json to_json(const RayCell& cell, int count) {
    const auto a_ray = [&](double RayCounts::*which) {
        return cell.a_ray ? number((*cell.a_ray).*which) : ordered_json(nullptr);
    };
    return {{"rays", name_of(cell.kind)},
            {"count", count},
            {"mrays_per_second", to_json(cell.mrays)},
            {"ratio", to_json(cell.ratio)},
            {"differing", cell.differing},
            {"verified", cell.verified},
            {"wrong", cell.wrong},
            {"agrees", cell.agrees},
            {"nodes_per_ray", a_ray(&RayCounts::nodes)},
            {"triangles_per_ray", a_ray(&RayCounts::triangles)}};
}

ordered_json to_json(const RayRow& row, const RayRace& race) {
    ordered_json json = {{"name", row.name}, {"title", row.title}};
    if (!row.failure.empty()) {
        json["failure"] = row.failure;
        return json;
    }
    ordered_json cells = ordered_json::array();
    for (std::size_t kind = 0; kind < row.cells.size(); ++kind)
        cells.push_back(to_json(row.cells[kind], race.ray_counts[kind]));
    json.update({{"exact", row.is_exact},
                 {"build_seconds", to_json(row.build_seconds)},
                 {"mtris_per_second", number(1e-6 * race.triangles / row.build_seconds.median)},
                 {"bytes_per_triangle", number(row.bytes_per_triangle)},
                 {"cells", cells}});
    return json;
}

ordered_json to_json(const RayRace& race) {
    ordered_json rows = ordered_json::array();
    for (const RayRow& row : race.rows) rows.push_back(to_json(row, race));
    return {{"mesh", race.mesh},
            {"triangles", race.triangles},
            {"left_out", race.left_out},
            {"truth", race.truth},
            {"rows", rows}};
}

ordered_json to_json(const RaySummary& s) {
    return {{"name", s.name},
            {"mean", to_json(s.mean)},
            {"worst", s.mean ? number(s.worst) : ordered_json(nullptr)},
            {"best", s.mean ? number(s.best) : ordered_json(nullptr)},
            {"why_not", s.why_not}};
}

// How plots show each structure. A name says what is built, then how it is walked: "sah_skip". What
// is built has a colour, 0 to 7, and its walks, counted from 0, have lines of their own.
ordered_json styles(const RaysBench& bench) {
    ordered_json result = ordered_json::object();
    std::vector<std::string> built; // in order of appearance
    std::vector<int> walks;
    for (const RayRace& race : bench.races)
        for (const RayRow& row : race.rows) {
            if (result.contains(row.name)) continue;
            const std::string what = row.name.substr(0, row.name.find('_'));
            const auto place =
                std::size_t(std::find(built.begin(), built.end(), what) - built.begin());
            if (place == built.size()) {
                built.push_back(what);
                walks.push_back(0);
            }
            result[row.name] = {{"built", what}, {"colour", place % 8}, {"walk", walks[place]++}};
        }
    return result;
}

} // namespace

ordered_json to_json(const RaysBench& bench) {
    ordered_json json = {{"kind", "raylab bench-rays"},
                         {"version", 1},
                         {"command", bench.command},
                         {"machine", to_json(bench.machine)},
                         {"threads", bench.options.threads},
                         {"rounds", bench.options.rounds},
                         {"builds", bench.options.builds},
                         {"seed", bench.options.seed},
                         {"width", bench.width},
                         {"height", bench.height},
                         {"baseline", bench.options.baseline},
                         {"scaling", bench.scaling},
                         {"tolerated_t", tolerated_t},
                         {"tolerated_share", tolerated_share},
                         {"interval_coverage", interval_coverage(bench.options.rounds)},
                         {"notes", bench.notes}};
    json["styles"] = styles(bench);
    json["races"] = ordered_json::array();
    for (const RayRace& race : bench.races) json["races"].push_back(to_json(race));
    json["summaries"] = ordered_json::array();
    for (const RaySummary& summary : summaries(bench))
        json["summaries"].push_back(to_json(summary));
    return json;
}

void write_rays_bench(const RaysBench& bench, const std::string& folder) {
    const ordered_json json = to_json(bench);
    write_file(folder + "/rays.json",
               json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
    write_file(folder + "/rays.csv", to_csv(bench));
    write_file(folder + "/rays.html", rays_page_html(json, to_string(bench.machine)));
}

} // namespace raylab::bench
