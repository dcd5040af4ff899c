// CUB: running sums over a block.
#pragma once

#include "cuda_runtime.h"

#include "common/simt/cub/block_scan.h"
