// The figures as text, for the terminal.
#include "grader/bench/figures.h"
#include "grader/bench/rays/rays_bench.h"

#include <fmt/format.h>

namespace raylab::bench {

std::string to_table(const RayRace& race, const std::string& baseline) {
    std::string text =
        fmt::format("{}: {} triangles{}; answers against those of {}\n", race.mesh, race.triangles,
                    race.left_out.empty() ? "" : " (without " + race.left_out + ")", race.truth);
    text += fmt::format("{:16} {:>28} {:>9} {:>15}\n", "", "build seconds", "Mtris/s",
                        "bytes/triangle");
    for (const RayRow& row : race.rows)
        text +=
            !row.failure.empty()
                ? fmt::format("{:16} {}\n", row.name, row.failure)
                : fmt::format("{:16} {:>28} {:>9} {:>15.1f}\n", row.name,
                              with_interval(row.build_seconds, 3),
                              figure(1e-6 * race.triangles / row.build_seconds.median, "{:.3g}"),
                              row.bytes_per_triangle);
    text +=
        fmt::format("{:9} {:16} {:>22} {:>20} {:>9} {:>9}  {}\n", "", "", "Mrays/s",
                    "times " + baseline, "nodes", "triangles", "answers that differ, are wrong");
    for (std::size_t kind = 0; kind < race.ray_counts.size(); ++kind)
        for (const RayRow& row : race.rows) {
            if (!row.failure.empty()) continue;
            const RayCell& cell = row.cells[kind];
            const auto count = [&](double RayCounts::*which) {
                return cell.a_ray ? figure((*cell.a_ray).*which, "{:.1f}") : "-";
            };
            text += fmt::format("{:9} {:16} {:>22} {:>20} {:>9} {:>9}  {} of {}, {} of {}{}\n",
                                name_of(cell.kind), row.name, with_interval(cell.mrays, 3),
                                ratio_text(cell.ratio), count(&RayCounts::nodes),
                                count(&RayCounts::triangles), cell.differing, race.ray_counts[kind],
                                cell.wrong, cell.verified, cell.agrees ? "" : ": no ratio");
        }
    return text;
}

std::string to_table(const std::vector<RaySummary>& summaries, const std::string& baseline) {
    std::string text =
        fmt::format("geometric mean over all meshes and kinds of rays, times {}\n", baseline);
    for (const RaySummary& s : summaries)
        text += s.mean ? fmt::format("{:16} {:>22}  {:.2f} to {:.2f}\n", s.name,
                                     with_interval(*s.mean, 3), s.worst, s.best)
                       : fmt::format("{:16} {:>22}  {}\n", s.name, "-", s.why_not);
    return text;
}

} // namespace raylab::bench
