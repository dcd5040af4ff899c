// CUB: reductions over a block.
#pragma once

#include "cuda_runtime.h"

#include "common/simt/cub/block_reduce.h"
