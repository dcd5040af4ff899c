// The machine: its options, its workers, and the error state that CUDA's functions talk about.
#pragma once

#include "common/simt/launch.h"
#include "common/simt/options.h"
#include "common/simt/runtime_errors.h"

#include <string>

namespace raylab::simt {

// Remembers an error and its report until cudaGetLastError() asks; returns the code.
cudaError_t refuse(cudaError_t code, const std::string& report);

// Remembers a fault inside a kernel, which stays until cudaDeviceReset().
// `told`: the report has been written and recorded already.
enum class Told { no, yes };
void remember_fault(cudaError_t code, const std::string& report, Told told = Told::no);

// Reports what is wrong in a kernel that goes on nevertheless.
void warn(const std::string& report);

// The fault that every call must return, or cudaSuccess.
cudaError_t sticky_error();

// How many worker threads the options ask for; 1 in a check build.
int worker_count();

// The dynamic shared memory that this kernel may have.
size_t shared_limit(const void* kernel);

// cudaDeviceReset(): no errors any more, and the limits of shared memory are the usual ones.
void forget_errors_and_limits();

} // namespace raylab::simt
