// The figures as comma-separated values.
#include "grader/bench/figures.h"
#include "grader/bench/rays/rays_bench.h"

#include <fmt/format.h>

namespace raylab::bench {

std::string to_csv(const RaysBench& bench) {
    std::string csv = "mesh,triangles,structure,title,threads,rounds,rays,count,";
    for (const char* name : {"mrays_per_second", "ratio", "build_seconds"}) csv += header_of(name);
    csv += "bytes_per_triangle,nodes_per_ray,triangles_per_ray,differing,verified,wrong,agrees,"
           "failure\r\n";
    for (const RayRace& race : bench.races)
        for (const RayRow& row : race.rows) {
            const std::string who = fmt::format(
                "{},{},{},{},{},{},", csv_text(race.mesh), race.triangles, csv_text(row.name),
                csv_text(row.title), bench.options.threads, bench.options.rounds);
            if (!row.failure.empty())
                csv += who + std::string(18, ',') + csv_text(row.failure) + "\r\n";
            for (std::size_t kind = 0; kind < row.cells.size(); ++kind) {
                const RayCell& cell = row.cells[kind];
                csv += fmt::format(
                    "{}{},{},{},{},{},{},{},{},{},{},{},{},\r\n", who, name_of(cell.kind),
                    race.ray_counts[kind], csv_measured(cell.mrays), csv_measured(cell.ratio),
                    csv_measured(row.build_seconds), csv_number(row.bytes_per_triangle),
                    cell.a_ray ? csv_number(cell.a_ray->nodes) : "",
                    cell.a_ray ? csv_number(cell.a_ray->triangles) : "", cell.differing,
                    cell.verified, cell.wrong, cell.agrees ? "yes" : "no");
            }
        }
    return csv;
}

} // namespace raylab::bench
