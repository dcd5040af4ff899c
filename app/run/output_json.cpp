// The report for programs: as it is, and as SARIF 2.1.0 (docs.oasis-open.org/sarif).
#include "app/run/output.h"
#include "common/simt/finding_text.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>

namespace raylab::app {

using Json = nlohmann::ordered_json;
using simt::Finding;

namespace {

std::string dumped(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json location(const simt::SourcePlace& place, const std::string& words) {
    const bool is_absolute = std::filesystem::path(place.file).is_absolute();
    Json physical = {{"artifactLocation", {{"uri", (is_absolute ? "file://" : "") + place.file}}}};
    if (place.line > 0) physical["region"] = {{"startLine", place.line}};
    if (place.line > 0 && place.column > 0) physical["region"]["startColumn"] = place.column;
    Json json = {{"physicalLocation", physical}};
    if (!words.empty()) json["message"] = {{"text", words}};
    return json;
}

Json sarif_result(const Finding& finding) {
    std::string words = finding.message + ".";
    if (!finding.advice.empty()) words += " To mend it: " + finding.advice + ".";
    if (const std::string who = in_words(finding.actor); !who.empty())
        words += " Seen in " + who + ".";
    Json json = {{"ruleId", finding.kind},
                 {"level", name(finding.severity)},
                 {"message", {{"text", words}}},
                 {"locations", Json::array({location(finding.place, "")})},
                 {"occurrenceCount", std::max<std::int64_t>(1, finding.count)}};
    if (finding.other)
        json["relatedLocations"] = Json::array({location(
            finding.other->place, finding.other->what + " " + in_words(finding.other->actor))});
    return json;
}

} // namespace

std::string to_json(const Result& result) {
    Json findings = Json::array(), runs = Json::array();
    for (const Finding& finding : result.findings)
        findings.push_back(Json::parse(to_json_line(finding)));
    for (const Execution& execution : result.executions) {
        Json run = {{"mode", execution.mode}};
        if (!execution.order.empty()) run["order"] = execution.order;
        run["seconds"] = execution.process.seconds;
        run["exit_code"] = execution.process.exit_code;
        run["signal"] = execution.process.signal;
        run["checked"] = Json::parse(to_json_line(execution.summary.value_or(simt::RunSummary{})));
        for (const simt::AccessCost& cost : execution.costs)
            run["accesses"].push_back(Json::parse(to_json_line(cost)));
        runs.push_back(run);
    }
    return dumped({{"sources", result.sources},
                   {"compiles", !result.executions.empty()},
                   {"host_code_unchecked", result.unchecked},
                   {"findings", findings},
                   {"runs", runs}});
}

std::string to_sarif(const Result& result) {
    std::map<std::string, int> kinds;
    Json results = Json::array(), rules = Json::array(), notes = Json::array();
    for (const Finding& finding : result.findings) {
        results.push_back(sarif_result(finding));
        if (kinds[finding.kind]++ == 0)
            rules.push_back({{"id", finding.kind}, {"name", finding.kind}});
    }
    for (const Execution& execution : result.executions)
        notes.push_back(
            {{"level", "note"}, {"message", {{"text", "checked " + what_was_checked(execution)}}}});
    const Json invocation = {{"executionSuccessful", !result.executions.empty()},
                             {"toolExecutionNotifications", notes}};
    const Json driver = {{"name", "raylab run"}, {"rules", rules}};
    return dumped({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                   {"version", "2.1.0"},
                   {"runs", Json::array({{{"tool", {{"driver", driver}}},
                                          {"invocations", Json::array({invocation})},
                                          {"results", results}}})}});
}

} // namespace raylab::app
