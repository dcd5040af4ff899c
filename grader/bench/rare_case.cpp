// The rare cases as JSON, as CSV and as a table for the terminal.
#include "grader/bench/rare_case.h"

#include "grader/bench/figures.h"

#include <fmt/format.h>

namespace raylab::bench {

using nlohmann::ordered_json;

namespace {

ordered_json to_json(const WavefrontCosts& costs) {
    return {{"seconds", costs.seconds},
            {"iterations", costs.iterations},
            {"launches", costs.launches},
            {"rays", costs.rays},
            {"blocks", costs.blocks},
            {"batches", costs.batches},
            {"share_of_compaction_and_sort", costs.removing},
            {"share_between_launches", costs.between}};
}

ordered_json to_json(const RareCaseRow& row) {
    const ordered_json megakernel =
        row.megakernel ? ordered_json{{"seconds", *row.megakernel}} : ordered_json(nullptr);
    return {{"case", row.name},
            {"scene", row.scene},
            {"why", row.why},
            {"width", row.width},
            {"height", row.height},
            {"megakernel", megakernel},
            {"without", to_json(row.without)},
            {"with", to_json(row.with)}};
}

} // namespace

ordered_json to_json(const std::vector<RareCaseRow>& rows) {
    ordered_json json = ordered_json::array();
    for (const RareCaseRow& row : rows) json.push_back(to_json(row));
    return json;
}

std::string to_csv(const std::vector<RareCaseRow>& rows) {
    std::string csv = "case,scene,width,height,compaction,seconds,megakernel_seconds,iterations,"
                      "live_rays,blocks,batches,launches,share_of_compaction_and_sort,"
                      "share_between_launches\r\n";
    for (const RareCaseRow& row : rows)
        for (const WavefrontCosts* c : {&row.without, &row.with}) {
            csv += fmt::format("{},{},{},{},{},{},{},", csv_text(row.name), csv_text(row.scene),
                               row.width, row.height, c == &row.with ? "yes" : "no",
                               csv_number(c->seconds),
                               row.megakernel ? csv_number(*row.megakernel) : "");
            csv +=
                fmt::format("{},{},{},{},{},{},{}\r\n", csv_number(c->iterations),
                            csv_number(c->rays / c->iterations), csv_number(c->blocks),
                            c->batches > 0 ? csv_number(c->batches) : "", csv_number(c->launches),
                            csv_number(c->removing), csv_number(c->between));
        }
    return csv;
}

std::string rare_case_header() {
    return fmt::format("Per sample of the whole image; live rays: mean of an iteration's; between: "
                       "share of the time between launches.\n"
                       "  {:20} {:>9} {:>7} {:>6} {:>9} {:>8} {:>8} {:>8} {:>9} {:>9}\n",
                       "", "ms", "to 02", "iter.", "live rays", "blocks", "batches", "launches",
                       "removing", "between");
}

std::string to_table(const RareCaseRow& row) {
    const auto ratio = [&](double seconds) {
        return row.megakernel ? fmt::format("{:.2f}", seconds / *row.megakernel) : "-";
    };
    const auto line = [&](const char* name, const WavefrontCosts& c) {
        return fmt::format("  {:20} {:9.3f} {:>7} {:6.0f} {:9.0f} {:8.0f} {:>8} {:8.0f} "
                           "{:7.1f} % {:7.1f} %\n",
                           name, 1e3 * c.seconds, ratio(c.seconds), c.iterations,
                           c.rays / c.iterations, c.blocks,
                           c.batches > 0 ? fmt::format("{:.0f}", c.batches) : "-", c.launches,
                           100 * c.removing, 100 * c.between);
    };
    std::string text =
        fmt::format("{}: {}, {} x {}. {}\n", row.name, row.scene, row.width, row.height, row.why);
    if (row.megakernel)
        text += fmt::format("  {:20} {:9.3f} {:>7}\n", "megakernel", 1e3 * *row.megakernel,
                            ratio(*row.megakernel));
    return text + line("without compaction", row.without) + line("with it", row.with);
}

} // namespace raylab::bench
