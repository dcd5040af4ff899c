// CUB: differences of neighbours.
#pragma once

#include "cuda_runtime.h"

#include "common/simt/cub/block_adjacent_difference.h"
