// Memory that host and device share: managed, mapped and registered; and questions about pointers.
//
// Host and device see one memory here in any case, so there is nothing to move or to map: a device
// pointer to host memory is the pointer itself.
#pragma once

#include "common/simt/runtime.h"

inline constexpr unsigned cudaMemAttachGlobal = 1, cudaMemAttachHost = 2, cudaMemAttachSingle = 4;
inline constexpr unsigned cudaHostAllocDefault = 0, cudaHostAllocPortable = 1,
                          cudaHostAllocMapped = 2, cudaHostAllocWriteCombined = 4;
inline constexpr unsigned cudaHostRegisterDefault = 0, cudaHostRegisterPortable = 1,
                          cudaHostRegisterMapped = 2, cudaHostRegisterIoMemory = 4,
                          cudaHostRegisterReadOnly = 8;
inline constexpr int cudaCpuDeviceId = -1, cudaInvalidDeviceId = -2;

namespace raylab::simt {

// From now on kernels and copies take memory from anywhere. Thrust with its C++ backend has its
// device vectors where the host has its own.
bool take_any_memory();

} // namespace raylab::simt

enum cudaMemoryType {
    cudaMemoryTypeUnregistered = 0,
    cudaMemoryTypeHost = 1,
    cudaMemoryTypeDevice = 2,
    cudaMemoryTypeManaged = 3,
};
struct cudaPointerAttributes {
    cudaMemoryType type;
    int device;
    void *devicePointer, *hostPointer;
};

enum cudaMemoryAdvise {
    cudaMemAdviseSetReadMostly = 1,
    cudaMemAdviseUnsetReadMostly = 2,
    cudaMemAdviseSetPreferredLocation = 3,
    cudaMemAdviseUnsetPreferredLocation = 4,
    cudaMemAdviseSetAccessedBy = 5,
    cudaMemAdviseUnsetAccessedBy = 6,
};

template <class T>
inline cudaError_t cudaMallocManaged(T** pointer, size_t bytes, unsigned = cudaMemAttachGlobal,
                                     raylab::simt::Where where = raylab::simt::Where::here()) {
    void* memory = nullptr;
    raylab::simt::check_result("cudaMallocManaged()", pointer, where);
    auto error = raylab::simt::allocate(&memory, bytes, raylab::simt::MemoryKind::managed, where);
    *pointer = static_cast<T*>(memory);
    return error;
}

template <class T>
inline cudaError_t cudaHostAlloc(T** pointer, size_t bytes, unsigned,
                                 raylab::simt::Where where = raylab::simt::Where::here()) {
    return cudaMallocHost(pointer, bytes, where);
}
// CUDA 2's cudaMallocHost(pointer, bytes, flags).
template <class T>
inline cudaError_t cudaMallocHost(T** pointer, size_t bytes, unsigned,
                                  raylab::simt::Where where = raylab::simt::Where::here()) {
    return cudaMallocHost(pointer, bytes, where);
}
template <class T>
inline cudaError_t cudaHostGetDevicePointer(T** device, void* host, unsigned = 0) {
    *device = static_cast<T*>(host);
    return cudaDeviceSynchronize();
}
cudaError_t cudaHostGetFlags(unsigned* flags, void* host);

// Lets kernels use memory that the program has from elsewhere.
cudaError_t cudaHostRegister(void* host, size_t bytes, unsigned flags,
                             raylab::simt::Where where = raylab::simt::Where::here());
cudaError_t cudaHostUnregister(void* host, raylab::simt::Where where = raylab::simt::Where::here());

// In the order of a stream, as everything.
template <class T>
inline cudaError_t cudaMallocAsync(T** pointer, size_t bytes, cudaStream_t,
                                   raylab::simt::Where where = raylab::simt::Where::here()) {
    return cudaMalloc(pointer, bytes, where);
}
inline cudaError_t cudaFreeAsync(void* pointer, cudaStream_t,
                                 raylab::simt::Where where = raylab::simt::Where::here()) {
    return cudaFree(pointer, where);
}

cudaError_t cudaMemPrefetchAsync(const void* pointer, size_t bytes, int device,
                                 cudaStream_t stream = nullptr);
cudaError_t cudaMemAdvise(const void* pointer, size_t bytes, cudaMemoryAdvise advice, int device);
cudaError_t cudaStreamAttachMemAsync(cudaStream_t stream, void* pointer, size_t bytes = 0,
                                     unsigned flags = cudaMemAttachSingle);

// Free and total memory of the host.
cudaError_t cudaMemGetInfo(size_t* free_bytes, size_t* total_bytes);
cudaError_t cudaPointerGetAttributes(cudaPointerAttributes* attributes, const void* pointer);
