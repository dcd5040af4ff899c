// raylab compare A B: error metrics, z-map, verdict, picture.
#include "app/commands.h"
#include "app/output.h"
#include "common/image/image_file.h"
#include "grader/judge/json.h"
#include "grader/report/report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace raylab::app {

namespace {

struct CompareOptions {
    std::string a, b, reference, folder;
    double alpha = 1e-3;
    bool json = false;
};

void print_metrics(const std::string& name, const Metrics& metrics) {
    fmt::print("{:24} relMSE {:.3g}, mean {:+.3f} %", name, metrics.rel_mse,
               100 * metrics.rel_error);
    if (std::isfinite(metrics.rel_bias))
        fmt::print(", {:.3f} % that noise does not explain", 100 * metrics.rel_bias);
    fmt::print("\n");
}

// One character a tile: how many standard errors a lies above (+) or below (-) b.
void print_z_map(const ZMap& map) {
    fmt::print(
        "z of each {0} x {0} tile (.: below 2, digits: |z|, +: 10 and more, ?: no variance)\n",
        map.tile);
    for (int row = 0; row < map.rows; ++row) {
        fmt::print("  ");
        for (int column = 0; column < map.columns; ++column) {
            const double z = std::fabs(map.z[static_cast<std::size_t>(row) * map.columns + column]);
            fmt::print("{}", std::isnan(z) ? "?"
                             : z < 2       ? "."
                             : z < 10      ? fmt::format("{:.0f}", std::floor(z))
                                           : "+");
        }
        fmt::print("\n");
    }
}

// The two side by side, their difference and the z-map, on one page.
void write_page(const CompareOptions& options, const Comparison& comparison, const Image& a,
                const Image& b) {
    ReportEntry entry;
    entry.scene = b.provenance.scene;
    entry.title = options.a + " against " + options.b;
    entry.lab = a.provenance.renderer;
    entry.passed = comparison.verdict.passed;
    entry.verdict = comparison.verdict;
    entry.facts = {{"relMSE of A", fmt::format("{:.3g}", comparison.metrics.rel_mse)},
                   {"mean error", fmt::format("{:+.3f} %", 100 * comparison.metrics.rel_error)}};
    entry.image = a;
    entry.reference = b;
    entry.details = comparison;
    write_report({"raylab compare", "", "raylab compare " + options.a + " " + options.b, {entry}},
                 options.folder);
}

ExitCode run_compare(const CompareOptions& options) {
    if (!options.folder.empty()) prepare_output(options.folder + "/report.html");
    const Image a = read_image(options.a), b = read_image(options.b);
    std::optional<Image> reference;
    if (!options.reference.empty()) reference = read_image(options.reference);
    const Comparison comparison = compare(a, b, reference ? &*reference : nullptr, options.alpha);
    if (!options.folder.empty()) write_page(options, comparison, a, b);
    if (options.json) {
        fmt::print("{}\n", nlohmann::json(comparison).dump(2));
    } else {
        fmt::print("{}\n", comparison.verdict.sentence);
        for (const std::string& hint : comparison.verdict.hints) fmt::print("note: {}\n", hint);
        if (!comparison.equal && !comparison.z_map.z.empty()) {
            if (comparison.metrics_b) {
                print_metrics("A against the reference", comparison.metrics);
                print_metrics("B against the reference", *comparison.metrics_b);
            } else {
                print_metrics("A against B", comparison.metrics);
            }
            print_z_map(comparison.z_map);
        }
    }
    return comparison.verdict.passed ? ExitCode::success : ExitCode::judged_failed;
}

} // namespace

Run add_compare(CLI::App& app) {
    auto options = std::make_shared<CompareOptions>();
    app.description("Compare two images statistically: do they show the same? 0 yes, 1 no.");
    app.add_option("A", options->a, "an image; .exr carries the variance that a verdict needs")
        ->required();
    app.add_option("B", options->b, "the image to compare it with")->required();
    app.add_option("--reference", options->reference, "measure both against this image");
    app.add_option("-o,--output", options->folder, "write report.html with the pictures here");
    app.add_option("--alpha", options->alpha, "how often two equal renders may be called different")
        ->check(CLI::Range(1e-12, 0.5))
        ->capture_default_str();
    app.add_flag("--json", options->json, "for programs");
    app.footer("Examples:\n"
               "  raylab compare out/cornell_01.exr out/cornell_02.exr\n"
               "  raylab compare mine.exr theirs.exr --reference scenes/references/cornell.exr\n"
               "  raylab compare mine.exr theirs.exr -o out/compare");
    return [options] { return run_compare(*options); };
}

} // namespace raylab::app
