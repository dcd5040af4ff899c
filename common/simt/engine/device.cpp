// What the device says about itself: properties, attributes, limits (runtime.h, api/device.h).
//
// Sizes that kernels meet are those of the machine; the others are those of a GPU of compute
// capability 7.5, so that programs which compute with them get something sensible.
#include "common/simt/api/device.h"
#include "common/simt/engine/machine.h"
#include "common/simt/engine/sanitizer.h"

#include <climits>
#include <cstdio>
#include <map>
#include <unistd.h>

using namespace raylab::simt;

cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int device) {
    if (device != 0) return cudaSetDevice(device);
    cudaDeviceProp p{};
    std::snprintf(p.name, sizeof p.name, "raylab CPU machine (%d %s)", worker_count(),
                  worker_count() == 1 ? "thread" : "threads");
    p.totalGlobalMem = size_t(sysconf(_SC_PHYS_PAGES)) * size_t(sysconf(_SC_PAGESIZE));
    p.sharedMemPerBlock = 48 << 10;
    p.sharedMemPerBlockOptin = 99 << 10;
    p.sharedMemPerMultiprocessor = 100 << 10;
    p.reservedSharedMemPerBlock = 1 << 10;
    p.major = 7; // threads of a warp go their own ways, as from Volta on
    p.minor = 5;
    p.multiProcessorCount = worker_count();
    p.warpSize = 32;
    p.maxThreadsPerBlock = p.maxThreadsPerMultiProcessor = 1024;
    p.maxBlocksPerMultiProcessor = 16;
    p.regsPerBlock = p.regsPerMultiprocessor = 65536;
    const int block[] = {1024, 1024, 64}, grid[] = {INT_MAX, 65535, 65535};
    for (int i = 0; i < 3; ++i) {
        p.maxThreadsDim[i] = block[i];
        p.maxGridSize[i] = grid[i];
        p.maxTexture3D[i] = p.maxSurface3D[i] = 16384;
    }
    p.memPitch = INT_MAX;
    p.totalConstMem = 64 << 10;
    p.clockRate = 1'000'000; // in kHz: clock64() counts nanoseconds
    p.memoryClockRate = 1'000'000;
    p.memoryBusWidth = 64;
    p.l2CacheSize = 1 << 20;
    p.textureAlignment = 512;
    p.texturePitchAlignment = 32;
    p.surfaceAlignment = 512;
    p.maxTexture1D = p.maxSurface1D = 131072;
    p.maxTexture1DLinear = 1 << 28;
    p.maxTexture2D[0] = p.maxSurface2D[0] = 131072;
    p.maxTexture2D[1] = p.maxSurface2D[1] = 65536;
    p.maxTexture2DLinear[0] = 131072;
    p.maxTexture2DLinear[1] = 65000;
    p.maxTexture2DLinear[2] = 2097120;
    p.deviceOverlap = p.concurrentKernels = p.canMapHostMemory = p.unifiedAddressing = 1;
    p.asyncEngineCount = p.streamPrioritiesSupported = p.hostNativeAtomicSupported = 1;
    p.globalL1CacheSupported = p.localL1CacheSupported = p.computePreemptionSupported = 1;
    p.integrated = p.managedMemory = p.concurrentManagedAccess = p.directManagedMemAccessFromHost =
        1;
    p.canUseHostPointerForRegisteredMem = p.hostRegisterSupported = p.memoryPoolsSupported = 1;
    p.singleToDoublePrecisionPerfRatio = 2;
#if !defined(RAYLAB_CHECK_ADDRESS)
    p.cooperativeLaunch = 1; // engine/cooperative.cpp
#endif
    *properties = p;
    return cudaSuccess;
}

cudaError_t cudaDeviceGetAttribute(int* value, cudaDeviceAttr attribute, int device) {
    cudaDeviceProp p;
    if (cudaError_t error = cudaGetDeviceProperties(&p, device)) return error;
    const std::map<int, size_t> values = {
        {cudaDevAttrMaxThreadsPerBlock, p.maxThreadsPerBlock},
        {cudaDevAttrMaxBlockDimX, p.maxThreadsDim[0]},
        {cudaDevAttrMaxBlockDimY, p.maxThreadsDim[1]},
        {cudaDevAttrMaxBlockDimZ, p.maxThreadsDim[2]},
        {cudaDevAttrMaxGridDimX, p.maxGridSize[0]},
        {cudaDevAttrMaxGridDimY, p.maxGridSize[1]},
        {cudaDevAttrMaxGridDimZ, p.maxGridSize[2]},
        {cudaDevAttrMaxSharedMemoryPerBlock, p.sharedMemPerBlock},
        {cudaDevAttrTotalConstantMemory, p.totalConstMem},
        {cudaDevAttrWarpSize, p.warpSize},
        {cudaDevAttrMaxPitch, p.memPitch},
        {cudaDevAttrMaxRegistersPerBlock, p.regsPerBlock},
        {cudaDevAttrClockRate, p.clockRate},
        {cudaDevAttrTextureAlignment, p.textureAlignment},
        {cudaDevAttrGpuOverlap, p.deviceOverlap},
        {cudaDevAttrMultiProcessorCount, p.multiProcessorCount},
        {cudaDevAttrKernelExecTimeout, p.kernelExecTimeoutEnabled},
        {cudaDevAttrIntegrated, p.integrated},
        {cudaDevAttrCanMapHostMemory, p.canMapHostMemory},
        {cudaDevAttrComputeMode, p.computeMode},
        {cudaDevAttrConcurrentKernels, p.concurrentKernels},
        {cudaDevAttrEccEnabled, p.ECCEnabled},
        {cudaDevAttrPciBusId, p.pciBusID},
        {cudaDevAttrPciDeviceId, p.pciDeviceID},
        {cudaDevAttrTccDriver, p.tccDriver},
        {cudaDevAttrMemoryClockRate, p.memoryClockRate},
        {cudaDevAttrGlobalMemoryBusWidth, p.memoryBusWidth},
        {cudaDevAttrL2CacheSize, p.l2CacheSize},
        {cudaDevAttrMaxThreadsPerMultiProcessor, p.maxThreadsPerMultiProcessor},
        {cudaDevAttrAsyncEngineCount, p.asyncEngineCount},
        {cudaDevAttrUnifiedAddressing, p.unifiedAddressing},
        {cudaDevAttrComputeCapabilityMajor, p.major},
        {cudaDevAttrComputeCapabilityMinor, p.minor},
        {cudaDevAttrStreamPrioritiesSupported, p.streamPrioritiesSupported},
        {cudaDevAttrGlobalL1CacheSupported, p.globalL1CacheSupported},
        {cudaDevAttrLocalL1CacheSupported, p.localL1CacheSupported},
        {cudaDevAttrMaxSharedMemoryPerMultiprocessor, p.sharedMemPerMultiprocessor},
        {cudaDevAttrMaxRegistersPerMultiprocessor, p.regsPerMultiprocessor},
        {cudaDevAttrManagedMemory, p.managedMemory},
        {cudaDevAttrHostNativeAtomicSupported, p.hostNativeAtomicSupported},
        {cudaDevAttrSingleToDoublePrecisionPerfRatio, p.singleToDoublePrecisionPerfRatio},
        {cudaDevAttrPageableMemoryAccess, p.pageableMemoryAccess},
        {cudaDevAttrConcurrentManagedAccess, p.concurrentManagedAccess},
        {cudaDevAttrComputePreemptionSupported, p.computePreemptionSupported},
        {cudaDevAttrCanUseHostPointerForRegisteredMem, p.canUseHostPointerForRegisteredMem},
        {cudaDevAttrCooperativeLaunch, p.cooperativeLaunch},
        {cudaDevAttrMaxSharedMemoryPerBlockOptin, p.sharedMemPerBlockOptin},
        {cudaDevAttrHostRegisterSupported, p.hostRegisterSupported},
        {cudaDevAttrMaxBlocksPerMultiprocessor, p.maxBlocksPerMultiProcessor},
        {cudaDevAttrMemoryPoolsSupported, p.memoryPoolsSupported},
    };
    auto found = values.find(int(attribute));
    if (found == values.end())
        return refuse(cudaErrorInvalidValue,
                      "error: cudaDeviceGetAttribute(): the CPU machine has no attribute " +
                          std::to_string(int(attribute)));
    *value = int(found->second);
    return cudaSuccess;
}

cudaError_t cudaDriverGetVersion(int* version) { return cudaRuntimeGetVersion(version); }

cudaError_t cudaRuntimeGetVersion(int* version) {
    *version = 12040; // the API's
    return cudaSuccess;
}
