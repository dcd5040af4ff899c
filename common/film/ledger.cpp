#include "common/film/ledger.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace raylab {

namespace {
constexpr const char* end_names[path_ends] = {"escaped", "absorbed", "roulette", "depth"};
}

std::uint64_t Ledger::rays() const {
    std::uint64_t sum = shadow_rays;
    for (const BounceCounts& bounce : bounces) sum += bounce.rays;
    return sum;
}

double lanes_alive(const BounceCounts& bounce) {
    return bounce.lanes == 0 ? 1.0
                             : static_cast<double>(bounce.rays) / static_cast<double>(bounce.lanes);
}

namespace {

double per_ray(std::uint64_t visits, const WalkSums& walks) {
    return walks.rays == 0 ? 0.0 : static_cast<double>(visits) / static_cast<double>(walks.rays);
}

// packs: the name of what is tested in the leaves, "triangle_packs" or "groups".
nlohmann::ordered_json walks_json(const WalkSums& walks, const char* packs) {
    return {{"rays", walks.rays},
            {"nodes_per_ray", per_ray(walks.nodes, walks)},
            {fmt::format("{}_per_ray", packs), per_ray(walks.packs, walks)}};
}

nlohmann::ordered_json shapes_json(const ShapeTreeFacts& shapes) {
    return {{"spheres", shapes.spheres},
            {"quads", shapes.quads},
            {"nodes", shapes.nodes},
            {"depth", shapes.depth},
            {"bytes", shapes.bytes},
            {"build_seconds", shapes.build_seconds},
            {"walks", walks_json(shapes.rays, "groups")},
            {"shadow_rays", walks_json(shapes.shadow_rays, "groups")}};
}

nlohmann::ordered_json structure_json(const StructureFacts& structure) {
    return {{"name", structure.name},
            {"walk", structure.walk},
            {"why", structure.why},
            {"triangles", structure.triangles},
            {"nodes", structure.nodes},
            {"triangle_packs", structure.triangle_packs},
            {"depth", structure.depth},
            {"bytes", structure.bytes},
            {"build_seconds", structure.build_seconds},
            {"shadow_rays", walks_json(structure.shadow_rays, "triangle_packs")}};
}

} // namespace

std::string to_json(const Ledger& ledger) {
    nlohmann::ordered_json json = {
        {"lab", ledger.lab},
        {"scene", ledger.scene},
        {"scene_hash", ledger.scene_hash},
        {"features", ledger.features},
        {"machine", ledger.machine},
        {"width", ledger.width},
        {"height", ledger.height},
        {"samples", ledger.samples},
        {"seconds", ledger.seconds},
        {"rays", ledger.rays()},
        {"shadow_rays", ledger.shadow_rays},
        {"non_finite_samples", ledger.rejected},
        {"threads_launched", ledger.threads_launched},
    };
    if (ledger.pool_paths > 0)
        json["pool"] = {{"paths", ledger.pool_paths}, {"bytes_per_path", ledger.path_bytes}};
    if (ledger.structure) json["structure"] = structure_json(*ledger.structure);
    if (ledger.shapes) json["shape_tree"] = shapes_json(*ledger.shapes);
    if (!ledger.stages.empty()) json["stages"] = nlohmann::ordered_json::array();
    for (const StageCounts& stage : ledger.stages)
        json["stages"].push_back({{"name", stage.name},
                                  {"launches", stage.launches},
                                  {"blocks", stage.blocks},
                                  {"threads", stage.threads},
                                  {"seconds", stage.seconds}});
    json["bounces"] = nlohmann::ordered_json::array();
    for (const BounceCounts& bounce : ledger.bounces) {
        nlohmann::ordered_json row = {{"rays", bounce.rays}};
        std::uint64_t ended = 0;
        for (int i = 0; i < path_ends; ++i) {
            row[end_names[i]] = bounce.ended[i];
            ended += bounce.ended[i];
        }
        row["out"] = bounce.rays - ended;
        row["lanes"] = bounce.lanes;
        row["lanes_share"] = lanes_alive(bounce);
        if (bounce.blocks > 0) {
            row["blocks"] = bounce.blocks;
            row["batches"] = bounce.batches;
        }
        if (ledger.structure) row["walks"] = walks_json(bounce.walks, "triangle_packs");
        json["bounces"].push_back(row);
    }
    return json.dump(2);
}

namespace {

// What each stage takes of the whole; what no stage takes is launching, copying and waiting.
std::string stage_table(const Ledger& ledger) {
    std::string table = fmt::format("{:>12} {:>10} {:>12} {:>14} {:>10} {:>7}\n", "stage",
                                    "launches", "blocks", "threads", "ms", "share");
    double rest = ledger.seconds;
    const auto share = [&](double seconds) { return 100 * seconds / ledger.seconds; };
    for (const StageCounts& stage : ledger.stages) {
        if (stage.launches == 0) continue;
        rest -= stage.seconds;
        table += fmt::format("{:>12} {:>10} {:>12} {:>14} {:>10.2f} {:>5.1f} %\n", stage.name,
                             stage.launches, stage.blocks, stage.threads, 1e3 * stage.seconds,
                             share(stage.seconds));
    }
    return table + fmt::format("{:>12} {:>10} {:>12} {:>14} {:>10.2f} {:>5.1f} %\n", "between", "",
                               "", "", 1e3 * rest, share(rest));
}

std::string walks_head(const char* packs) {
    return fmt::format("{:>12} {:>12} {:>12} {:>12}\n", "walks of", "rays", "nodes/ray", packs);
}

std::string walks_row(const std::string& name, const WalkSums& walks) {
    if (walks.rays == 0) return "";
    return fmt::format("{:>12} {:>12} {:>12.2f} {:>12.2f}\n", name, walks.rays,
                       per_ray(walks.nodes, walks), per_ray(walks.packs, walks));
}

// What the structure is, and what a ray visits of it, by bounce.
std::string structure_table(const Ledger& ledger) {
    const StructureFacts& facts = *ledger.structure;
    std::string table = fmt::format(
        "{} triangles: {}, {}\n{:>12} nodes, {} packs of triangles, depth {}, {:.2f} MiB, "
        "built in {:.2f} ms; walk: {}\n",
        facts.triangles, facts.name, facts.why, facts.nodes, facts.triangle_packs, facts.depth,
        static_cast<double>(facts.bytes) / (1 << 20), 1e3 * facts.build_seconds, facts.walk);
    table += walks_head("packs/ray");
    for (std::size_t b = 0; b < ledger.bounces.size(); ++b)
        table += walks_row(fmt::format("bounce {}", b), ledger.bounces[b].walks);
    return table + walks_row("shadow rays", facts.shadow_rays);
}

// The same of the tree over spheres and quads, for all bounces together.
std::string shapes_table(const ShapeTreeFacts& facts) {
    return fmt::format(
               "{} spheres, {} quads: boxes over groups of sixteen\n{:>12} nodes, depth {}, "
               "{:.2f} MiB, built in {:.2f} ms\n",
               facts.spheres, facts.quads, facts.nodes, facts.depth,
               static_cast<double>(facts.bytes) / (1 << 20), 1e3 * facts.build_seconds) +
           walks_head("groups/ray") + walks_row("all bounces", facts.rays) +
           walks_row("shadow rays", facts.shadow_rays);
}

} // namespace

std::string to_table(const Ledger& ledger) {
    std::string table =
        fmt::format("{:>6} {:>12} {:>10} {:>10} {:>10} {:>10}  {}\n", "bounce", "rays", "escaped",
                    "absorbed", "roulette", "depth", "lanes alive");
    for (std::size_t b = 0; b < ledger.bounces.size() && ledger.bounces[b].rays > 0; ++b) {
        const BounceCounts& bounce = ledger.bounces[b];
        const double alive = lanes_alive(bounce);
        table += fmt::format("{:>6} {:>12} {:>10} {:>10} {:>10} {:>10}  ", b, bounce.rays,
                             bounce.ended[0], bounce.ended[1], bounce.ended[2], bounce.ended[3]);
        table += bounce.lanes == 0
                     ? std::string("-\n")
                     : fmt::format("{:5.1f} % {}\n", 100 * alive,
                                   std::string(static_cast<std::size_t>(alive * 30), '#'));
    }
    if (ledger.structure) table += structure_table(ledger);
    if (ledger.shapes) table += shapes_table(*ledger.shapes);
    if (!ledger.stages.empty()) table += stage_table(ledger);
    return table;
}

} // namespace raylab
