// The operations of collectives.h, for whichever block the caller belongs to.
#include "common/simt/collectives.h"

#include "common/simt/engine/block.h"
#include "common/simt/engine/report.h"
#include "common/simt/launch.h"

namespace raylab::simt {

static Block& block_at(const Site& site) {
    if (!current_block) end_with_message(outside_of_kernel(site));
    return *current_block;
}

int sync_block(const Site& site, int predicate) {
    return block_at(site).sync_block(site, predicate);
}
void sync_warp(const Site& site, unsigned mask) {
    block_at(site).warp_operation(Wait::warp, site, mask, 0, 0);
}
unsigned vote(const Site& site, unsigned mask, int predicate) {
    return unsigned(block_at(site).warp_operation(Wait::vote, site, mask, predicate != 0, 0));
}
uint64_t shuffle(const Site& site, unsigned mask, uint64_t value, int source) {
    return block_at(site).warp_operation(Wait::shuffle, site, mask, value, source);
}
void gather(const Site& site, unsigned mask, uint64_t value, uint64_t* all) {
    block_at(site).gather(site, mask, value, all);
}
unsigned active_mask(const Site& site) { return block_at(site).active_mask(site); }
void trap(const Site& site) { block_at(site).trap(site); }

void* dynamic_shared_memory() { return current_block ? current_block->shared() : nullptr; }

} // namespace raylab::simt
