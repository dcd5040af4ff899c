// CUB: what threads of a block or a warp do together.
#pragma once

#include "cuda_runtime.h"

#include "common/simt/cub/block_adjacent_difference.h"
#include "common/simt/cub/block_reduce.h"
#include "common/simt/cub/block_scan.h"
#include "common/simt/cub/warp.h"
