#include "grader/bench/against.h"

#include <fmt/format.h>

#include <optional>

namespace raylab::bench {

namespace {

using nlohmann::json;

const json* find_by_name(const json& list, const std::string& name) {
    for (const json& entry : list)
        if (entry.at("name") == name) return &entry;
    return nullptr;
}

// The values of the rounds, if all are known and above 0.
std::optional<std::vector<double>> rounds_of(const json& measured) {
    if (!measured.is_object()) return {};
    std::vector<double> values;
    for (const json& value : measured.at("rounds")) {
        if (!value.is_number() || !(value.get<double>() > 0)) return {};
        values.push_back(value);
    }
    if (values.empty()) return {};
    return values;
}

// Samples a second from the milliseconds a sample takes.
std::optional<std::vector<double>> speeds_of(const json& row) {
    auto values = rounds_of(row.at("ms_per_spp"));
    if (values)
        for (double& value : *values) value = 1000 / value;
    return values;
}

void compare_quantity(Comparison& result, Change change,
                      const std::optional<std::vector<double>>& now,
                      const std::optional<std::vector<double>>& other) {
    if (!now || !other) {
        result.notes.push_back(fmt::format(
            "{}, {}: {} not compared, since a round of {} run was disturbed; draw more "
            "samples or wait for a quiet machine.",
            change.scene, change.contestant, change.quantity, now ? "the other" : "this"));
        return;
    }
    change.ratio = ratio_of(*now, *other);
    change.verdict = !change.ratio.is_change() ? "noise"
                     : change.ratio.median > 1 ? "better"
                                               : "worse";
    result.changes.push_back(change);
}

void compare_rows(Comparison& result, const std::string& scene, const json& now, const json& other,
                  const std::string& common_baseline) {
    const std::string name = now.at("name");
    for (const json* row : {&now, &other})
        if (row->contains("failure") || !row->at("agrees").get<bool>()) {
            result.notes.push_back(
                fmt::format("{}, {}: not compared, since its image was not right in {} run.", scene,
                            name, row == &now ? "this" : "the other"));
            return;
        }
    Change change{scene, name, "speed", "seconds of two runs", {}, ""};
    const bool relative = !common_baseline.empty() && name != common_baseline;
    if (relative) {
        change.formed = "ratios to " + common_baseline;
        compare_quantity(result, change, rounds_of(now.at("speed_ratio")),
                         rounds_of(other.at("speed_ratio")));
        change.quantity = "efficiency";
        compare_quantity(result, change, rounds_of(now.at("efficiency_ratio")),
                         rounds_of(other.at("efficiency_ratio")));
        return;
    }
    compare_quantity(result, change, speeds_of(now), speeds_of(other));
    change.quantity = "efficiency";
    compare_quantity(result, change, rounds_of(now.at("efficiency")),
                     rounds_of(other.at("efficiency")));
}

// Why two runs of a scene cannot be compared, or nothing.
std::string obstacle(const json& now, const json& other, const json& scene_now,
                     const json& scene_other) {
    if (scene_now.at("hash") != scene_other.at("hash")) return "the scene file is another version";
    if (scene_now.at("width") != scene_other.at("width") ||
        scene_now.at("height") != scene_other.at("height"))
        return fmt::format("its film was {} x {} there", scene_other.at("width").get<int>(),
                           scene_other.at("height").get<int>());
    if (now.at("spp").back() != other.at("spp").back())
        return fmt::format("it had {} spp there", other.at("spp").back().get<int>());
    if (now.at("threads") != other.at("threads"))
        return fmt::format("it had {} threads there", other.at("threads").get<int>());
    return "";
}

} // namespace

json parse_bench(const std::string& text, const std::string& file) {
    json parsed;
    try {
        parsed = json::parse(text);
    } catch (const json::parse_error& error) {
        throw AgainstError(fmt::format("'{}' is no JSON: {}", file, error.what()));
    }
    if (!parsed.is_object() || parsed.value("kind", json()) != "raylab bench")
        throw AgainstError(fmt::format("'{}' is no bench.json: /kind should be \"raylab bench\"; "
                                       "give the bench.json of another run",
                                       file));
    if (parsed.value("version", json()) != 1)
        throw AgainstError(
            fmt::format("'{}': /version should be 1; make that run anew with this program", file));
    return parsed;
}

Comparison compare_runs(const json& now, const json& other, const std::string& file) try {
    Comparison result;
    result.file = file;
    result.commit = other.at("machine").at("commit");
    const std::string baseline = now.at("baseline");
    const bool same_baseline = other.at("baseline") == baseline;
    if (!same_baseline)
        result.notes.push_back(fmt::format(
            "The other run's baseline is {}, this one's {}: seconds of two runs are compared, "
            "which another load changes too.",
            other.at("baseline").get<std::string>(), baseline));
    for (const json& scene : now.at("scenes")) {
        const std::string name = scene.at("name");
        const json* scene_other = find_by_name(other.at("scenes"), name);
        const std::string why = scene_other ? obstacle(now, other, scene, *scene_other)
                                            : "the other run did not have it";
        if (!why.empty()) {
            result.notes.push_back(fmt::format("{}: not compared, since {}.", name, why));
            continue;
        }
        for (const json& row : scene.at("rows"))
            if (const json* row_other = find_by_name(scene_other->at("rows"), row.at("name")))
                compare_rows(result, name, row, *row_other, same_baseline ? baseline : "");
    }
    return result;
} catch (const json::exception& error) {
    throw AgainstError(fmt::format("'{}' is damaged: {}", file, error.what()));
}

std::string to_table(const Comparison& comparison) {
    std::string text =
        fmt::format("against {} (commit {}): this run over that one, above 1 is better\n",
                    comparison.file, comparison.commit.empty() ? "unknown" : comparison.commit);
    double by_chance = 0;
    for (const Change& c : comparison.changes) {
        text += fmt::format("{:24} {:13} {:10} {:6.3f} [{:.3f}, {:.3f}]  {:6}  {}\n", c.scene,
                            c.contestant, c.quantity, c.ratio.median, c.ratio.low, c.ratio.high,
                            c.verdict, c.formed);
        by_chance += 1 - c.ratio.coverage;
    }
    if (!comparison.changes.empty())
        text += fmt::format("noise: the interval holds 1. Of these {} rows, {:.1f} would be called "
                            "a change by chance.\n",
                            comparison.changes.size(), by_chance);
    for (const std::string& note : comparison.notes) text += note + "\n";
    return text;
}

} // namespace raylab::bench
