// What clangd reads in front of a .cu file (RaylabKernels.cmake). clang knows CUDA's syntax,
// launches and `extern __shared__` included, and finds CUDA's functions in the CPU machine's
// headers. It reads the file as it would for a GPU, so a kernel may call only what a GPU has: the
// functions below, what is marked HD or
// __device__, and constexpr functions. Nothing is compiled with this header.
#pragma once

#if !defined(__CUDA__)
#error "editor.h is for an editor's clang alone: include common/simt/cuda.h"
#endif

// clang 14 crashes on a class with a member of the type std::pair if pair's operator= has a
// requires clause: the library's older pair has none.
#include <compare>
#include <concepts>
#include <version>
#pragma push_macro("__cpp_lib_concepts")
#undef __cpp_lib_concepts
#include <bits/stl_pair.h>
#pragma pop_macro("__cpp_lib_concepts")

// The headers in front of a file are read once and kept, and clang 14 keeps the device's operators
// new and delete alone. Those of the host are found as templates. (A delete-expression in host code
// still crashes clangd 14: unique_ptr does not.)
#include <exception>
#include <new>
#define __CLANG_CUDA_WRAPPERS_NEW // clang's <new>, which would define the device's
namespace raylab::simt {
struct OfHost {};
} // namespace raylab::simt
template <class = void> void* operator new (std::size_t, raylab::simt::OfHost = {});
template <class = void> void* operator new[](std::size_t, raylab::simt::OfHost = {});
template <class = void> void operator delete (void*, raylab::simt::OfHost = {});
template <class = void> void operator delete[](void*, raylab::simt::OfHost = {});

#pragma clang force_cuda_host_device begin
#include "common/simt/cuda.h"

#include "common/math/vec.h"

#include <cassert>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>
#pragma clang force_cuda_host_device end

// What clang makes of <<<grid, block, shared_bytes, stream>>>: one or the other, by the CUDA that
// it finds.
extern "C" unsigned cudaConfigureCall(dim3 grid, dim3 block, size_t shared_bytes = 0,
                                      cudaStream_t stream = nullptr);
extern "C" unsigned __cudaPushCallConfiguration(dim3 grid, dim3 block, size_t shared_bytes = 0,
                                                cudaStream_t stream = nullptr);
