// Brute force: what a walk without a structure does, and what every stub does.
#pragma once

#include "common/math/hd.h"
#include "labs/04_accel/structure.h"

namespace raylab::lab04 {

template <class Query> HD void visit_all_packs(Query& query) {
    for (int pack = 0; pack < query.packs(); ++pack)
        if (query.visit(pack)) return;
}

// For the table of walks (walk_table.h): without a structure there is no other way to go.
struct AllPacks {
    static constexpr const char* name = "auto";
    static constexpr const char* title = "all triangles";
    static constexpr const char* when_endless = "a loop that does not count up";

    template <class Query> HD static void walk(const StructureView&, Query& query) {
        visit_all_packs(query);
    }
};

} // namespace raylab::lab04
