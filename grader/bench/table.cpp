// The figures as text: a table for the terminal and bench.csv.
#include "grader/bench/bench.h"
#include "grader/bench/figures.h"

#include <fmt/format.h>

#include <cmath>

namespace raylab::bench {

std::string to_csv(const Bench& bench) {
    std::string csv = "scene,width,height,contestant,title,threads,spp,rounds,agrees,verdict,";
    for (const char* name : {"ms_per_spp", "start_up_seconds", "mse", "rel_mse", "efficiency",
                             "exponent", "seconds_to_target", "speed_ratio", "efficiency_ratio"})
        csv += header_of(name);
    csv += "bias,bias_half_width_95,rays_per_second,bytes_per_path\r\n";
    const Plan& plan = bench.options.plan;
    for (const SceneResult& scene : bench.scenes)
        for (const Row& row : scene.rows) {
            csv += fmt::format("{},{},{},{},{},{},{},{},", csv_text(scene.name), scene.width,
                               scene.height, csv_text(row.name), csv_text(row.title), bench.threads,
                               plan.spp.back(), plan.rounds);
            if (!row.failure.empty()) {
                csv += "no," + csv_text(row.failure) + std::string(31, ',') + "\r\n";
                continue;
            }
            csv += fmt::format("{},{},", row.agrees ? "yes" : "no", csv_text(row.verdict));
            for (const Measured* m : {&row.ms_per_spp, &row.start_up, &row.mse, &row.rel_mse,
                                      &row.efficiency, &row.exponent, &row.seconds_to_target})
                csv += csv_measured(*m) + ",";
            csv += csv_measured(row.speed_ratio) + "," + csv_measured(row.efficiency_ratio) + ",";
            csv += csv_number(row.bias.relative) + "," + csv_number(row.bias.half_width_95) + ",";
            csv += (row.rays_per_second > 0 ? csv_number(row.rays_per_second) : "") + "," +
                   (row.bytes_per_path > 0 ? csv_number(row.bytes_per_path) : "") + "\r\n";
        }
    return csv;
}

std::string to_table(const SceneResult& scene) {
    std::string baseline;
    for (const Row& row : scene.rows)
        if (row.is_baseline) baseline = row.name;
    std::string text = fmt::format(
        "{} {}x{}, {}\n{:13} {:>9} {:>9} {:>9} {:>25} {:>21} {:>9} {:>15}  {}\n", scene.name,
        scene.width, scene.height, scene.truth, "", "ms/spp", "start-up", "relMSE", "efficiency",
        "times " + baseline, "s to goal", "bias", "error check");
    for (const Row& row : scene.rows) {
        if (!row.failure.empty()) {
            text += fmt::format("{:13} {}\n", row.name, row.failure);
            continue;
        }
        const std::string bias = std::isfinite(row.bias.relative)
                                     ? fmt::format("{:+.2f} +- {:.2f} %", 100 * row.bias.relative,
                                                   100 * row.bias.half_width_95)
                                     : "-";
        text += fmt::format("{:13} {:>9} {:>9} {:>9} {:>25} {:>21} {:>9} {:>15}  {}\n", row.name,
                            figure(row.ms_per_spp.median, "{:.4g}"),
                            figure(row.start_up.median, "{:.2f} s"),
                            figure(row.rel_mse.median, "{:.3g}"), with_interval(row.efficiency),
                            ratio_text(row.efficiency_ratio),
                            figure(row.seconds_to_target.median, "{:.3g}"), bias, row.verdict);
        for (const std::string& remark : row.remarks) text += fmt::format("{:13} {}\n", "", remark);
    }
    return text;
}

} // namespace raylab::bench
