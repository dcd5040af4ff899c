// The CUDA runtime's error codes, as far as the CPU machine has a use for them, with CUDA's values.
//
// As on a GPU there are two kinds. A refused call (a bad launch configuration, a bad copy) is
// returned, and remembered until cudaGetLastError() asks. A fault inside a kernel is sticky: every
// later call returns it until cudaDeviceReset(). The full story is in last_report() (options.h).
#pragma once

enum cudaError_t {
    cudaSuccess = 0,
    cudaErrorInvalidValue = 1,
    cudaErrorMemoryAllocation = 2,
    cudaErrorInvalidConfiguration = 9,
    cudaErrorInvalidSymbol = 13,
    cudaErrorInvalidMemcpyDirection = 21,
    cudaErrorInsufficientDriver = 35,
    cudaErrorNoDevice = 100,
    cudaErrorInvalidDevice = 101,
    cudaErrorInvalidResourceHandle = 400,
    cudaErrorNotReady = 600,
    cudaErrorIllegalAddress = 700,
    cudaErrorLaunchOutOfResources = 701,
    cudaErrorAssert = 710,
    cudaErrorLaunchFailure = 719,
    cudaErrorNotSupported = 801,
};

// The latest error; cudaGetLastError() forgets it, unless it is sticky.
cudaError_t cudaGetLastError();
cudaError_t cudaPeekAtLastError();

// "cudaErrorInvalidValue" and "invalid argument".
const char* cudaGetErrorName(cudaError_t error);
const char* cudaGetErrorString(cudaError_t error);
