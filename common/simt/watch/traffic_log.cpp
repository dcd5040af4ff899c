// All traffic of the program, said when it ends; see traffic.h.
#include "common/simt/engine/findings.h"
#include "common/simt/watch/traffic.h"

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
