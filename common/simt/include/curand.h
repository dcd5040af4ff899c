// cuRAND's host API.
#pragma once

#include "cuda_runtime.h"

#include "common/simt/random/host_api.h"

#define CURAND_H_ // helper_cuda.h offers its functions by this
