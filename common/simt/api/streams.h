// Streams and events, the less usual calls. Everything is done when the call returns (runtime.h),
// so there is nothing to wait for, and a callback is called at once.
#pragma once

#include "common/simt/runtime.h"

inline constexpr unsigned cudaEventBlockingSync = 1, cudaEventInterprocess = 4,
                          cudaEventRecordDefault = 0, cudaEventRecordExternal = 1,
                          cudaEventWaitDefault = 0;

#define cudaStreamLegacy ((cudaStream_t)0x1)
#define cudaStreamPerThread ((cudaStream_t)0x2)

using cudaStreamCallback_t = void (*)(cudaStream_t stream, cudaError_t status, void* data);
using cudaHostFn_t = void (*)(void* data);

inline cudaError_t cudaStreamCreateWithPriority(cudaStream_t* stream, unsigned flags, int) {
    return cudaStreamCreateWithFlags(stream, flags);
}
inline cudaError_t cudaStreamGetPriority(cudaStream_t, int* priority) {
    *priority = 0;
    return cudaDeviceSynchronize();
}
inline cudaError_t cudaStreamGetFlags(cudaStream_t, unsigned* flags) {
    *flags = cudaStreamDefault;
    return cudaDeviceSynchronize();
}
inline cudaError_t cudaEventRecordWithFlags(cudaEvent_t event, cudaStream_t stream = nullptr,
                                            unsigned = 0) {
    return cudaEventRecord(event, stream);
}
inline cudaError_t cudaStreamAddCallback(cudaStream_t stream, cudaStreamCallback_t callback,
                                         void* data, unsigned) {
    callback(stream, cudaStreamQuery(stream), data);
    return cudaDeviceSynchronize();
}
inline cudaError_t cudaLaunchHostFunc(cudaStream_t stream, cudaHostFn_t function, void* data) {
    cudaStreamSynchronize(stream); // it comes after what the stream was given before
    function(data);
    return cudaDeviceSynchronize();
}

// Which memory should stay in the cache, and other attributes: accepted, and without effect.
enum cudaAccessProperty {
    cudaAccessPropertyNormal,
    cudaAccessPropertyStreaming,
    cudaAccessPropertyPersisting
};
struct cudaAccessPolicyWindow {
    void* base_ptr;
    size_t num_bytes;
    float hitRatio;
    cudaAccessProperty hitProp, missProp;
};
enum cudaStreamAttrID {
    cudaStreamAttributeAccessPolicyWindow = 1,
    cudaStreamAttributeSynchronizationPolicy = 3,
    cudaStreamAttributePriority = 8
};
union cudaStreamAttrValue {
    cudaAccessPolicyWindow accessPolicyWindow;
    int syncPolicy, priority;
};
inline cudaError_t cudaStreamSetAttribute(cudaStream_t stream, cudaStreamAttrID,
                                          const cudaStreamAttrValue*) {
    return cudaStreamQuery(stream);
}
inline cudaError_t cudaCtxResetPersistingL2Cache() { return cudaDeviceSynchronize(); }
