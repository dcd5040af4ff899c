// Brute force: what a walk without a structure does, and what every stub does.
#pragma once

#include "common/math/hd.h"

namespace raylab::lab04 {

template <class Query> HD void visit_all_blocks(Query& query) {
    for (int block = 0; block < query.blocks(); ++block)
        if (query.visit(block)) return;
}

} // namespace raylab::lab04
