// Findings as lines of JSON, and folded; see finding.h.
#include "common/simt/finding.h"

#include <nlohmann/json.hpp>

#include <map>
#include <sstream>
#include <tuple>

namespace raylab::simt {

using Json = nlohmann::ordered_json;

namespace {

Json to_json(const SourcePlace& place) {
    Json json = {{"file", place.file}, {"line", place.line}};
    if (place.column > 0) json["column"] = place.column;
    return json;
}

void put_actor(Json& json, const Actor& actor) {
    if (!actor.kernel.empty()) json["kernel"] = actor.kernel;
    if (actor.block) json["block"] = *actor.block;
    if (actor.thread) json["thread"] = *actor.thread;
}

SourcePlace place_of(const Json& json) {
    return {json.value("file", ""), json.value("line", 0), json.value("column", 0)};
}

Actor actor_of(const Json& json) {
    Actor actor;
    actor.kernel = json.value("kernel", "");
    if (json.contains("block")) actor.block = json["block"].get<Index3>();
    if (json.contains("thread")) actor.thread = json["thread"].get<Index3>();
    return actor;
}

Severity severity_of(const std::string& word) {
    for (Severity severity : {Severity::note, Severity::warning})
        if (word == name(severity)) return severity;
    return Severity::error;
}

Finding finding_of(const Json& json) {
    Finding finding;
    finding.kind = json.at("kind").get<std::string>();
    finding.severity = severity_of(json.value("severity", "error"));
    finding.place = place_of(json);
    finding.message = json.value("message", "");
    finding.advice = json.value("advice", "");
    finding.actor = actor_of(json);
    if (json.contains("other")) {
        const Json& other = json["other"];
        finding.other = {place_of(other), other.value("what", ""), actor_of(other)};
    }
    finding.count = json.value("count", std::int64_t(1));
    finding.mode = json.value("mode", "");
    return finding;
}

AccessCost cost_of(const Json& json) {
    return {json.at("kernel"),
            json.at("memory"),
            json.at("access"),
            place_of(json),
            json.at("bytes"),
            json.at("requests"),
            json.at("threads_per_warp"),
            json.value("sectors_per_request", 0.0),
            json.value("least_sectors_per_request", 0.0),
            json.value("bank_conflicts", std::uint64_t{0})};
}

} // namespace

const char* name(Severity severity) {
    return severity == Severity::note      ? "note"
           : severity == Severity::warning ? "warning"
                                           : "error";
}

std::string to_json_line(const Finding& finding) {
    Json json = {{"kind", finding.kind}, {"severity", name(finding.severity)}};
    json.update(to_json(finding.place));
    json["message"] = finding.message;
    if (!finding.advice.empty()) json["advice"] = finding.advice;
    put_actor(json, finding.actor);
    if (finding.other) {
        json["other"] = to_json(finding.other->place);
        if (!finding.other->what.empty()) json["other"]["what"] = finding.other->what;
        put_actor(json["other"], finding.other->actor);
    }
    if (finding.count != 1) json["count"] = finding.count;
    if (!finding.mode.empty()) json["mode"] = finding.mode;
    // A file's name need not be UTF-8.
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string to_json_line(const RunSummary& summary) {
    return Json{{"launches", summary.launches},
                {"threads", summary.threads},
                {"allocations", summary.allocations},
                {"bytes", summary.bytes}}
        .dump();
}

std::string to_json_line(const AccessCost& cost) {
    Json json = {{"requests", cost.requests}, {"kernel", cost.kernel}};
    json.update(to_json(cost.place));
    json["memory"] = cost.memory;
    json["access"] = cost.access;
    json["bytes"] = cost.bytes;
    json["threads_per_warp"] = cost.threads_per_warp;
    if (cost.memory == "shared") {
        json["bank_conflicts"] = cost.bank_conflicts;
    } else {
        json["sectors_per_request"] = cost.sectors_per_request;
        json["least_sectors_per_request"] = cost.least_sectors_per_request;
    }
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

FindingsFile parse_findings(const std::string& lines) {
    FindingsFile file;
    std::istringstream text(lines);
    for (std::string line; std::getline(text, line);) {
        const Json json = Json::parse(line, nullptr, false);
        try {
            if (!json.is_object()) continue;
            if (json.contains("kind"))
                file.findings.push_back(finding_of(json));
            else if (json.contains("requests"))
                file.costs.push_back(cost_of(json));
            else if (json.contains("launches"))
                file.summary = {json.at("launches"), json.at("threads"), json.at("allocations"),
                                json.at("bytes")};
        } catch (const Json::exception&) { // of another kind
        }
    }
    return file;
}

std::vector<Finding> folded(const std::vector<Finding>& findings) {
    std::vector<Finding> kept;
    std::map<std::tuple<std::string, Severity, SourcePlace, SourcePlace>, std::size_t> known;
    for (const Finding& finding : findings) {
        const SourcePlace other = finding.other ? finding.other->place : SourcePlace{};
        const auto [at, is_new] =
            known.try_emplace({finding.kind, finding.severity, finding.place, other}, kept.size());
        if (is_new)
            kept.push_back(finding);
        else
            kept[at->second].count += finding.count;
    }
    return kept;
}

} // namespace raylab::simt
