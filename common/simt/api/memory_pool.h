// Memory pools: where cudaMallocAsync() takes memory from. Here each allocation stands alone, so a
// pool is a name that keeps its threshold and nothing else.
#pragma once

#include "common/simt/api/managed.h"

#include <cstdint>
#include <cstring>

enum cudaMemPoolAttr {
    cudaMemPoolReuseFollowEventDependencies = 1,
    cudaMemPoolReuseAllowOpportunistic = 2,
    cudaMemPoolReuseAllowInternalDependencies = 3,
    cudaMemPoolAttrReleaseThreshold = 4,
    cudaMemPoolAttrReservedMemCurrent = 5,
    cudaMemPoolAttrReservedMemHigh = 6,
    cudaMemPoolAttrUsedMemCurrent = 7,
    cudaMemPoolAttrUsedMemHigh = 8
};
enum cudaMemAllocationType { cudaMemAllocationTypeInvalid = 0, cudaMemAllocationTypePinned = 1 };
enum cudaMemAllocationHandleType { cudaMemHandleTypeNone = 0 };
enum cudaMemLocationType { cudaMemLocationTypeInvalid = 0, cudaMemLocationTypeDevice = 1 };
struct cudaMemLocation {
    cudaMemLocationType type;
    int id;
};
struct cudaMemPoolProps {
    cudaMemAllocationType allocType;
    cudaMemAllocationHandleType handleTypes;
    cudaMemLocation location;
    void* win32SecurityAttributes;
    unsigned char reserved[64];
};

struct CUmemPoolHandle_st {
    uint64_t release_threshold = 0;
};
using cudaMemPool_t = CUmemPoolHandle_st*;

inline cudaError_t cudaDeviceGetDefaultMemPool(cudaMemPool_t* pool, int) {
    static CUmemPoolHandle_st of_device;
    *pool = &of_device;
    return cudaSuccess;
}
inline cudaError_t cudaDeviceGetMemPool(cudaMemPool_t* pool, int device) {
    return cudaDeviceGetDefaultMemPool(pool, device);
}
inline cudaError_t cudaDeviceSetMemPool(int, cudaMemPool_t) { return cudaSuccess; }
inline cudaError_t cudaMemPoolCreate(cudaMemPool_t* pool, const cudaMemPoolProps*) {
    *pool = new CUmemPoolHandle_st;
    return cudaSuccess;
}
inline cudaError_t cudaMemPoolDestroy(cudaMemPool_t pool) {
    delete pool;
    return cudaSuccess;
}
inline cudaError_t cudaMemPoolTrimTo(cudaMemPool_t, size_t) { return cudaSuccess; }

// The threshold is a uint64_t; of the other attributes there is nothing to tell.
inline cudaError_t cudaMemPoolSetAttribute(cudaMemPool_t pool, cudaMemPoolAttr attribute,
                                           void* value) {
    if (attribute == cudaMemPoolAttrReleaseThreshold)
        std::memcpy(&pool->release_threshold, value, sizeof pool->release_threshold);
    return cudaSuccess;
}
inline cudaError_t cudaMemPoolGetAttribute(cudaMemPool_t pool, cudaMemPoolAttr attribute,
                                           void* value) {
    if (attribute != cudaMemPoolAttrReleaseThreshold) return cudaErrorNotSupported;
    std::memcpy(value, &pool->release_threshold, sizeof pool->release_threshold);
    return cudaSuccess;
}

template <class T>
inline cudaError_t
cudaMallocFromPoolAsync(T** pointer, size_t bytes, cudaMemPool_t, cudaStream_t stream,
                        raylab::simt::Where where = raylab::simt::Where::here()) {
    return cudaMallocAsync(pointer, bytes, stream, where);
}
