// Cooperative groups: thread blocks, tiles, coalesced groups and grids.
#pragma once

#include "cuda_runtime.h"

#include "common/simt/groups/lanes.h"
#include "common/simt/groups/thread_group.h"
