// CUB: reductions over a warp.
#pragma once

#include "cuda_runtime.h"

#include "common/simt/cub/warp.h"
