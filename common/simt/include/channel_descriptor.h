// NVIDIA spreads the runtime over many headers; here all of it is in cuda_runtime.h.
#pragma once

#include "cuda_runtime.h"
