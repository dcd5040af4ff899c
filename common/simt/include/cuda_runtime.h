// What nvcc puts in front of every .cu file, for programs that were not written for raylab: found
// by -Icommon/simt/include. The labs include common/simt/cuda.h, which is a small part of this.
//
// The macros say to the program that a CUDA compiler reads it. They come last: raylab's own headers
// must not take the CPU machine for nvcc.
#pragma once

// With C++20, libstdc++'s math.h makes std::lerp() global, and helper_math.h has one of its own;
// nvcc reads C++17. Reading math.h first, with another name in that place, keeps it from this.
#include <cmath>
#define lerp abs
#include <math.h>
#undef lerp

#include "common/simt/cuda.h"

#include "common/simt/api/arithmetic.h"
#include "common/simt/api/conversions.h"
#include "common/simt/api/device.h"
#include "common/simt/api/integers.h"
#include "common/simt/api/kernels.h"
#include "common/simt/api/managed.h"
#include "common/simt/api/memory_access.h"
#include "common/simt/api/memory_pool.h"
#include "common/simt/api/pitched.h"
#include "common/simt/api/streams.h"
#include "common/simt/api/texture_reference.h"
#include "common/simt/api/warp.h"

// nvcc's front end reads these as well, and programs count on it.
#include <climits>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <stdlib.h>

// helper_cuda.h offers its functions by these.
#define __CUDA_RUNTIME_H__
#define __CUDA_RUNTIME_API_H__
#define __DRIVER_TYPES_H__
#define __VECTOR_TYPES_H__
#define __VECTOR_FUNCTIONS_H__

#define CUDART_VERSION 12040
#define __CUDART_API_VERSION CUDART_VERSION
#define CUDART_CB
#define CUDARTAPI

#define __CUDACC__
#define __CUDACC_VER_MAJOR__ 12
#define __CUDACC_VER_MINOR__ 4
#define __CUDACC_VER_BUILD__ 0

#if defined(THRUST_DEVICE_SYSTEM) // the program is compiled with thrust
[[maybe_unused]] static const bool raylab_takes_any_memory = raylab::simt::take_any_memory();
#endif
