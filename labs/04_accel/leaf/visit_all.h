// Brute force: what a walk without a structure does, and what every stub does.
#pragma once

#include "common/math/hd.h"

namespace raylab::lab04 {

template <class Query> HD void visit_all_packs(Query& query) {
    for (int pack = 0; pack < query.packs(); ++pack)
        if (query.visit(pack)) return;
}

} // namespace raylab::lab04
