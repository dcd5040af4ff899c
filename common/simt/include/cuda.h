// CUDA's driver API has no place on the CPU machine; programs that include its header for the sake
// of a version or a name of the runtime compile.
#pragma once

#include "cuda_runtime.h"

#define CUDA_VERSION 12040
