// The figures as text: a table for the terminal and bench.csv.
#include "grader/bench/bench.h"

#include <fmt/format.h>

#include <cmath>

namespace raylab::bench {

namespace {

std::string figure(double value, const char* format) {
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

// The median over its interval, an end of which may be open.
std::string with_interval(const Measured& m, int digits = 4) {
    if (!m.is_known()) return "-";
    const auto end = [&](double v) {
        return std::isfinite(v) ? fmt::format("{:.{}g}", v, digits) : "open";
    };
    return fmt::format("{:.{}g} [{}, {}]", m.median, digits, end(m.low), end(m.high));
}

std::string ratio_text(const std::optional<Measured>& ratio) {
    return ratio ? with_interval(*ratio, 3) : "-";
}

// A field of CSV: quoted, quotes doubled, if it holds what would end it.
std::string csv_text(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string csv_number(double value) {
    return std::isfinite(value) ? fmt::format("{:.7g}", value) : "";
}

std::string csv_measured(const Measured& m) {
    return csv_number(m.median) + "," + csv_number(m.low) + "," + csv_number(m.high);
}

std::string csv_measured(const std::optional<Measured>& m) { return m ? csv_measured(*m) : ",,"; }

std::string header_of(const char* name) { return fmt::format("{0},{0}_low,{0}_high,", name); }

} // namespace

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

std::string to_table(const std::vector<TraversalResult>& results) {
    std::string text = fmt::format(
        "closest hits, one thread, Mrays/s: raylab's brute force and {}\n", embree_version());
    for (const TraversalResult& t : results)
        for (const TraversalRow& row : t.rows)
            text += fmt::format(
                "{:24} {:>7} triangles  {:7} {:>22} {:>22}  {}, {} of {} hits differ{}\n", t.scene,
                t.triangles, row.rays, with_interval(row.raylab_mrays),
                with_interval(row.embree_mrays),
                row.ratio ? "ratio " + ratio_text(row.ratio) : "no ratio", row.differing, row.count,
                t.left_out.empty() ? "" : " (without " + t.left_out + ")");
    return text;
}

} // namespace raylab::bench
