// The one header that every kernel file includes: CUDA, whichever machine runs it.
//
// nvcc, and the host code of a CUDA build, get NVIDIA's runtime. Any other compiler gets the CPU
// machine: the same language and the same functions, run by the host's threads (README.md).
#pragma once

#if defined(__CUDACC__) || defined(RAYLAB_CUDA)
#include <cuda_runtime.h>
#else
#define RAYLAB_CPU_MACHINE
#include "common/simt/atomics.h"
#include "common/simt/collectives.h"
#include "common/simt/device_math.h"
#include "common/simt/index.h"
#include "common/simt/launch.h"
#include "common/simt/qualifiers.h"
#include "common/simt/runtime.h"
#include "common/simt/vector_types.h"
#endif
