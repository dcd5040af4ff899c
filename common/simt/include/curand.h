// cuRAND's host API has no place on the CPU machine; the device API is in curand_kernel.h.
#pragma once

#include "cuda_runtime.h"

enum curandStatus_t { CURAND_STATUS_SUCCESS = 0, CURAND_STATUS_NOT_INITIALIZED = 101 };
