// All traffic of the program, said when it ends; see traffic.h.
#include "common/simt/engine/findings.h"
#include "common/simt/watch/traffic.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace raylab::simt::watch {

namespace {

AccessCost cost_of(const std::string& kernel, const SourcePlace& place, const Traffic& t) {
    const bool is_shared = t.memory == Memory::shared;
    return {kernel,
            is_shared ? "shared" : "global",
            t.writes ? "write" : "read",
            place,
            t.bytes,
            t.requests,
            t.active_threads(),
            is_shared ? 0 : t.sectors_per_request(),
            is_shared ? 0 : double(t.least_sectors) / double(t.requests),
            is_shared ? t.bank_conflicts() : 0};
}

} // namespace

std::string traffic_table(const std::string& kernel, const std::map<SourcePlace, Traffic>& lines) {
    std::vector<std::pair<SourcePlace, Traffic>> rows(lines.begin(), lines.end());
    const auto cost = [](const Traffic& t) { return t.sectors + t.wavefronts; };
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const auto& a, const auto& b) { return cost(a.second) > cost(b.second); });
    std::string text = "kernel " + kernel +
                       "\n  memory  access   requests  threads/warp  sectors/request (least)  bank "
                       "conflicts  line\n";
    for (const auto& [place, t] : rows) {
        char row[256];
        const bool is_shared = t.memory == Memory::shared;
        std::snprintf(row, sizeof row, "  %-7s %-6s %10llu  %12.1f  ",
                      is_shared ? "shared" : "global", t.writes ? "write" : "read",
                      static_cast<unsigned long long>(t.requests), t.active_threads());
        text += row;
        if (is_shared)
            std::snprintf(row, sizeof row, "%23s  %14llu", "",
                          static_cast<unsigned long long>(t.bank_conflicts()));
        else
            std::snprintf(row, sizeof row, "%14.1f (%6.1f)  %14s", t.sectors_per_request(),
                          double(t.least_sectors) / double(t.requests), "");
        text += row;
        text += "  " + place.file + ":" + std::to_string(place.line) + ":" +
                std::to_string(place.column) + "\n";
    }
    return text;
}

void add_traffic(const std::string& kernel, const std::map<SourcePlace, Traffic>& lines) {
    using Kernels = std::map<std::string, std::map<SourcePlace, Traffic>>;
    static Kernels* kernels = [] {
        std::atexit([] {
            for (const auto& [name, all] : *kernels) {
                std::fputs(traffic_table(name, all).c_str(), stderr);
                for (const auto& [place, traffic] : all) record(cost_of(name, place, traffic));
            }
        });
        return new Kernels;
    }();
    for (const auto& [place, traffic] : lines) (*kernels)[kernel][place] += traffic;
}

} // namespace raylab::simt::watch
