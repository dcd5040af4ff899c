// What clang reads in front of a program by anybody: editor.h, then the machine's headers by
// NVIDIA's names, so that their functions count as functions of a GPU, whichever of them the
// program includes. Nothing is compiled with this header.
#pragma once

#include "common/simt/editor.h"

#pragma clang force_cuda_host_device begin
#include <cooperative_groups.h>
#include <cooperative_groups/memcpy_async.h>
#include <cooperative_groups/reduce.h>
#include <cooperative_groups/scan.h>
#include <cuda_bf16.h>
#include <cuda_fp16.h>
#include <cuda_runtime.h>
#include <curand_kernel.h>
#pragma clang force_cuda_host_device end
