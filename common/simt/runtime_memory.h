// Device memory: allocation, copies, and symbols.
//
// Host and device share one memory, but which is which is known, and copies check it. In the
// address sanitizer's build device memory is out of bounds for host code (engine/memory.cpp).
#pragma once

#include "common/simt/runtime_errors.h"
#include "common/simt/where.h"

#include <cstddef>

using cudaStream_t = struct CUstream_st*;

enum cudaMemcpyKind {
    cudaMemcpyHostToHost = 0,
    cudaMemcpyHostToDevice = 1,
    cudaMemcpyDeviceToHost = 2,
    cudaMemcpyDeviceToDevice = 3,
    cudaMemcpyDefault = 4, // look at the pointers
};

namespace raylab::simt {

enum class MemoryKind { device, pinned_host, symbol, managed };

cudaError_t allocate(void** pointer, size_t bytes, MemoryKind kind, const Where& where);
cudaError_t release(void* pointer, MemoryKind kind, const Where& where);
cudaError_t release_device(void* pointer, const Where& where); // device or managed

// Makes a __device__ or __constant__ variable known as device memory.
void register_symbol(const void* symbol, size_t bytes, const Where& where);

// Where a call is to leave a pointer must be host memory; else tells it.
void check_result(const char* call, void* result, const Where& where);

// While one of these lives, the copies that its thread asks for are given to a stream, and nothing
// waits for them.
class InStream {
  public:
    explicit InStream(cudaStream_t stream);
    ~InStream();
    InStream(const InStream&) = delete;
    InStream& operator=(const InStream&) = delete;
};

} // namespace raylab::simt

// Device memory, aligned to 256 bytes, not initialised. 0 bytes, or an error, give a
// null pointer.
template <class T>
inline cudaError_t cudaMalloc(T** pointer, size_t bytes,
                              raylab::simt::Where where = raylab::simt::Where::here()) {
    void* memory = nullptr;
    raylab::simt::check_result("cudaMalloc()", pointer, where);
    auto error = raylab::simt::allocate(&memory, bytes, raylab::simt::MemoryKind::device, where);
    *pointer = static_cast<T*>(memory);
    return error;
}
inline cudaError_t cudaFree(void* pointer,
                            raylab::simt::Where where = raylab::simt::Where::here()) {
    return raylab::simt::release_device(pointer, where);
}

// Page-locked host memory, which kernels may use too.
template <class T>
inline cudaError_t cudaMallocHost(T** pointer, size_t bytes,
                                  raylab::simt::Where where = raylab::simt::Where::here()) {
    void* memory = nullptr;
    raylab::simt::check_result("cudaMallocHost()", pointer, where);
    auto error =
        raylab::simt::allocate(&memory, bytes, raylab::simt::MemoryKind::pinned_host, where);
    *pointer = static_cast<T*>(memory);
    return error;
}
inline cudaError_t cudaFreeHost(void* pointer,
                                raylab::simt::Where where = raylab::simt::Where::here()) {
    return raylab::simt::release(pointer, raylab::simt::MemoryKind::pinned_host, where);
}

// Every copy is done when the call returns, also the "Async" ones, but the watch remembers in which
// stream they would be. Ranges that are not where `kind`
// says, or leave their allocation, give cudaErrorInvalidValue and a report.
cudaError_t cudaMemcpy(void* to, const void* from, size_t bytes, cudaMemcpyKind kind,
                       raylab::simt::Where where = raylab::simt::Where::here());
cudaError_t cudaMemset(void* to, int byte, size_t bytes,
                       raylab::simt::Where where = raylab::simt::Where::here());

inline cudaError_t cudaMemcpyAsync(void* to, const void* from, size_t bytes, cudaMemcpyKind kind,
                                   cudaStream_t stream = nullptr,
                                   raylab::simt::Where where = raylab::simt::Where::here()) {
    const raylab::simt::InStream in(stream);
    return cudaMemcpy(to, from, bytes, kind, where);
}
inline cudaError_t cudaMemsetAsync(void* to, int byte, size_t bytes, cudaStream_t stream = nullptr,
                                   raylab::simt::Where where = raylab::simt::Where::here()) {
    const raylab::simt::InStream in(stream);
    return cudaMemset(to, byte, bytes, where);
}

template <class T>
inline cudaError_t cudaGetSymbolAddress(void** pointer, const T& symbol,
                                        raylab::simt::Where where = raylab::simt::Where::here()) {
    raylab::simt::register_symbol(&symbol, sizeof(T), where);
    *pointer = const_cast<void*>(static_cast<const void*>(&symbol));
    return cudaSuccess;
}

template <class T> inline cudaError_t cudaGetSymbolSize(size_t* bytes, const T&) {
    *bytes = sizeof(T);
    return cudaSuccess;
}

template <class T>
inline cudaError_t cudaMemcpyToSymbol(T& symbol, const void* from, size_t bytes, size_t offset = 0,
                                      cudaMemcpyKind kind = cudaMemcpyHostToDevice,
                                      raylab::simt::Where where = raylab::simt::Where::here()) {
    void* address = nullptr;
    cudaGetSymbolAddress(&address, symbol, where);
    return cudaMemcpy(static_cast<char*>(address) + offset, from, bytes, kind, where);
}

template <class T>
inline cudaError_t cudaMemcpyFromSymbol(void* to, const T& symbol, size_t bytes, size_t offset = 0,
                                        cudaMemcpyKind kind = cudaMemcpyDeviceToHost,
                                        raylab::simt::Where where = raylab::simt::Where::here()) {
    void* address = nullptr;
    cudaGetSymbolAddress(&address, symbol, where);
    return cudaMemcpy(to, static_cast<char*>(address) + offset, bytes, kind, where);
}
