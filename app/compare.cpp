// raylab compare A B, or A1 A2 ... --with B1 B2 ...: error metrics, z-map, verdict, picture.
#include "app/commands.h"
#include "common/cli/files.h"
#include "common/image/image_file.h"
#include "grader/judge/json.h"
#include "grader/report/report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace raylab::app {

namespace {

struct CompareCommand {
    std::vector<std::string> images, with; // two images, or replicates of either side
    std::string reference, folder;
    CompareOptions options;
    bool json = false;
};

// The images of one side, which must be renders of one scene with seeds of their own.
Replicates read_side(const std::vector<std::string>& paths) {
    Replicates side;
    for (const std::string& path : paths) {
        Image image = read_image(path);
        for (int r = 0; r < side.count(); ++r) {
            const Image& other = side.images[r];
            const auto refuse = [&](const std::string& what) {
                throw UsageError(fmt::format("'{}' and '{}' {}", paths[r], path, what));
            };
            if (image.width != other.width || image.height != other.height)
                refuse("are not of the same size: replicates show one picture");
            if (image.provenance.scene_hash != other.provenance.scene_hash)
                refuse("show different scenes: replicates differ in their seed alone");
            if (image.mean == other.mean)
                refuse("are the same image: replicates need seeds of their own, since what they "
                       "differ by tells their noise");
        }
        side.add(std::move(image));
    }
    return side;
}

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

std::string side_name(const std::vector<std::string>& paths) {
    return paths.size() == 1 ? paths[0] : fmt::format("{} and {} more", paths[0], paths.size() - 1);
}

// Writes one page: the two images side by side, their difference and the z-map.
void write_page(const CompareCommand& command, const Comparison& comparison) {
    const Image &a = comparison.mean_a, &b = comparison.mean_b;
    const std::string title = side_name(command.images) + " against " + side_name(command.with);
    ReportEntry entry;
    entry.scene = b.provenance.scene;
    entry.title = title;
    entry.lab = a.provenance.renderer;
    entry.passed = comparison.verdict.passed;
    entry.decided = comparison.decided;
    entry.verdict = comparison.verdict;
    const Metrics metrics = comparison.metrics();
    entry.facts = {{"relMSE of A", fmt::format("{:.3g}", metrics.rel_mse)},
                   {"mean error", fmt::format("{:+.3f} %", 100 * metrics.rel_error)}};
    entry.image = a;
    entry.reference = b;
    entry.details = comparison;
    write_report({"raylab compare", "", "raylab compare " + title, {entry}}, command.folder);
}

void print(const Comparison& comparison) {
    fmt::print("{}\n", comparison.verdict.sentence);
    for (const std::string& hint : comparison.verdict.hints) fmt::print("note: {}\n", hint);
    const std::optional<Measures>& measured = comparison.verdict.measured;
    if (comparison.equal || !measured) return;
    if (comparison.metrics_a) {
        print_metrics("A against the reference", *comparison.metrics_a);
        print_metrics("B against the reference", *comparison.metrics_b);
    } else {
        print_metrics("A against B", measured->metrics);
    }
    print_z_map(measured->z_map);
}

ExitCode run_compare(CompareCommand command) {
    if (command.with.empty()) {
        if (command.images.size() != 2)
            throw UsageError("two images are compared, or replicates of either side: "
                             "raylab compare A1 A2 --with B1 B2");
        command.with = {command.images.back()};
        command.images.pop_back();
    }
    if (!command.folder.empty()) prepare_output(command.folder + "/report.html");
    const Replicates a = read_side(command.images), b = read_side(command.with);
    std::optional<Image> reference;
    if (!command.reference.empty()) reference = read_image(command.reference);
    const Comparison comparison = compare(a, b, reference ? &*reference : nullptr, command.options);
    if (!command.folder.empty()) write_page(command, comparison);
    if (command.json)
        fmt::print("{}\n", nlohmann::json(comparison).dump(2));
    else
        print(comparison);
    return !comparison.decided         ? ExitCode::bad_usage
           : comparison.verdict.passed ? ExitCode::success
                                       : ExitCode::judged_failed;
}

} // namespace

Run add_compare(CLI::App& app) {
    auto command = std::make_shared<CompareCommand>();
    app.description("Compare two pictures statistically: do they show the same?");
    app.add_option("IMAGES", command->images,
                   "A and B; or, before --with, renders of A that differ in their seed")
        ->required();
    app.add_option("--with", command->with,
                   "renders of B that differ in their seed: what they differ by tells their noise");
    app.add_option("--reference", command->reference, "measure both against this image");
    app.add_flag("--exact", command->options.exact,
                 "an image without variance, such as a closed form's, has no noise");
    app.add_option("-o,--output", command->folder, "write report.html with the pictures here");
    app.add_option("--alpha", command->options.alpha,
                   "how often two equal renders may be called different")
        ->check(CLI::Range(1e-12, 0.5))
        ->capture_default_str();
    app.add_flag("--json", command->json, "for programs");
    app.footer(
        "Examples:\n"
        "  raylab compare out/cornell_01.exr out/cornell_02.exr\n"
        "  raylab compare mine.exr theirs.exr --reference scenes/references/cornell.exr\n"
        "  raylab compare mine.exr --with theirs_seed1.pfm theirs_seed2.pfm -o out/compare\n"
        "An .exr that raylab rendered with two samples a pixel or more knows its noise. Of any\n"
        "other image give two replicates or more, of any format.\n"
        "Exit code 0: they show the same; 1: they do not; 2: the noise that is known cannot\n"
        "decide it, and the sentence says what would.");
    return [command] { return run_compare(*command); };
}

} // namespace raylab::app
