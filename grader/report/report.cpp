// results.json, and both files to disk.
#include "grader/report/report.h"

#include "common/cli/files.h"
#include "grader/judge/json.h"

#include <algorithm>
#include <filesystem>

namespace raylab {

bool has_pair(const ReportEntry& e) {
    return e.image && e.reference && e.image->width == e.reference->width &&
           e.image->height == e.reference->height;
}

nlohmann::json report_json(const Report& report) {
    using nlohmann::json;
    json entries = json::array();
    for (const ReportEntry& e : report.entries) {
        json facts = json::object(), metrics;
        for (const Fact& fact : e.facts) facts[fact.label] = fact.value;
        if (has_pair(e)) metrics = e.verdict.measured.value_or(Measures{}).metrics;
        entries.push_back({{"scene", e.scene},
                           {"title", e.title},
                           {"reason", e.reason},
                           {"lab", e.lab},
                           {"passed", e.passed},
                           {"decided", e.decided},
                           {"verdict", e.verdict},
                           {"checks", e.checks},
                           {"seconds", e.seconds},
                           {"facts", facts},
                           {"metrics", metrics},
                           {"lanes_share", e.lanes_alive},
                           {"details", e.details}});
    }
    const bool passed = std::all_of(report.entries.begin(), report.entries.end(),
                                    [](const ReportEntry& e) { return e.passed; });
    return {{"version", 1},
            {"title", report.title},
            {"machine", report.machine},
            {"command", report.command},
            {"passed", passed},
            {"entries", entries}};
}

void write_report(const Report& report, const std::string& folder) {
    const std::filesystem::path path(folder);
    prepare_output((path / "report.html").string());
    write_file((path / "report.html").string(), report_html(report));
    // Text of a student's program may not be valid UTF-8: its wrong bytes are replaced, and nothing
    // fails.
    write_file((path / "results.json").string(),
               report_json(report).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
                   "\n");
}

} // namespace raylab
