// The runtime's calls beyond what the labs use, against the CUDA runtime's manual.
#include "common/simt/tests/settings.h"

using namespace raylab::simt;

#include <channel_descriptor.h>
#include <cuda_profiler_api.h>
#include <driver_functions.h>
#include <driver_types.h>
#include <surface_types.h>
#include <texture_types.h>

#if !defined(__DRIVER_TYPES_H__) || !defined(__CUDA_RUNTIME_H__) || !defined(__CUDACC__)
#error "helper_cuda.h looks for these"
#endif

namespace {

__global__ void increment(int* values, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) ++values[i];
}

__global__ void sum_columns(const char* rows, size_t pitch, int width, int height, int* sums) {
    int x = threadIdx.x;
    if (x >= width) return;
    for (int y = 0; y < height; ++y) sums[x] += ((const int*)(rows + y * pitch))[x];
}

struct Quiet {
    Quiet() { set_options({.print_reports = false}); }
    ~Quiet() {
        cudaGetLastError();
        set_options({});
    }
};

TEST(ForeignMemory, PoolsKeepTheirThreshold) {
    cudaMemPool_t own, of_device;
    cudaMemPoolProps props = {};
    props.allocType = cudaMemAllocationTypePinned;
    ASSERT_EQ(cudaMemPoolCreate(&own, &props), cudaSuccess);
    ASSERT_EQ(cudaDeviceGetDefaultMemPool(&of_device, 0), cudaSuccess);
    uint64_t wanted = 12345, kept = 0, of_other = 1;
    EXPECT_EQ(cudaMemPoolSetAttribute(own, cudaMemPoolAttrReleaseThreshold, &wanted), cudaSuccess);
    EXPECT_EQ(cudaMemPoolGetAttribute(own, cudaMemPoolAttrReleaseThreshold, &kept), cudaSuccess);
    EXPECT_EQ(kept, wanted);
    EXPECT_EQ(cudaMemPoolGetAttribute(of_device, cudaMemPoolAttrReleaseThreshold, &of_other),
              cudaSuccess);
    EXPECT_EQ(of_other, 0u);
    int *memory, host = 0;
    ASSERT_EQ(cudaMallocFromPoolAsync(&memory, sizeof(int), own, nullptr), cudaSuccess);
    cudaMemset(memory, 0, sizeof(int));
    increment<<<1, 1>>>(memory, 1);
    cudaMemcpy(&host, memory, sizeof(int), cudaMemcpyDeviceToHost);
    EXPECT_EQ(host, 1);
    EXPECT_EQ(cudaFreeAsync(memory, nullptr), cudaSuccess);
    EXPECT_EQ(cudaMemPoolDestroy(own), cudaSuccess);
}

} // namespace

TEST(ForeignMemory, ManagedMemoryIsForHostAndKernels) {
    int* values = nullptr;
    ASSERT_EQ(cudaMallocManaged(&values, 10 * sizeof(int)), cudaSuccess);
    for (int i = 0; i < 10; ++i) values[i] = i;
    EXPECT_EQ(cudaMemPrefetchAsync(values, 40, 0), cudaSuccess);
    EXPECT_EQ(cudaMemAdvise(values, 40, cudaMemAdviseSetReadMostly, 0), cudaSuccess);
    increment<<<1, 32>>>(values, 10);
    ASSERT_EQ(cudaDeviceSynchronize(), cudaSuccess);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(values[i], i + 1);
    // It may be either end of a copy, whatever the direction says.
    int host[10] = {7};
    EXPECT_EQ(cudaMemcpy(values, host, 40, cudaMemcpyHostToDevice), cudaSuccess);
    EXPECT_EQ(cudaMemcpy(values + 5, host, 4, cudaMemcpyHostToHost), cudaSuccess);
    EXPECT_EQ(cudaMemcpy(host + 1, values, 4, cudaMemcpyDeviceToHost), cudaSuccess);
    EXPECT_EQ(host[1], 7);
    EXPECT_EQ(values[5], 7);
    cudaPointerAttributes about;
    EXPECT_EQ(cudaPointerGetAttributes(&about, values + 3), cudaSuccess);
    EXPECT_EQ(about.type, cudaMemoryTypeManaged);
    EXPECT_EQ(cudaFree(values), cudaSuccess);
}

TEST(ForeignMemory, MappedAndRegisteredHostMemoryIsForKernels) {
    int *host = nullptr, *device = nullptr;
    ASSERT_EQ(cudaHostAlloc((void**)&host, 4 * sizeof(int), cudaHostAllocMapped), cudaSuccess);
    ASSERT_EQ(cudaHostGetDevicePointer((void**)&device, (void*)host, 0), cudaSuccess);
    for (int i = 0; i < 4; ++i) host[i] = 0;
    increment<<<1, 4>>>(device, 4);
    EXPECT_EQ(cudaDeviceSynchronize(), cudaSuccess);
    EXPECT_EQ(host[3], 1);
    cudaPointerAttributes about;
    EXPECT_EQ(cudaPointerGetAttributes(&about, host), cudaSuccess);
    EXPECT_EQ(about.type, cudaMemoryTypeHost);
    EXPECT_EQ(cudaFreeHost(host), cudaSuccess);

    std::vector<int> own(4, 10);
    EXPECT_EQ(cudaPointerGetAttributes(&about, own.data()), cudaSuccess);
    EXPECT_EQ(about.type, cudaMemoryTypeUnregistered);
    ASSERT_EQ(cudaHostRegister(own.data(), 16, cudaHostRegisterDefault), cudaSuccess);
    increment<<<1, 4>>>(own.data(), 4);
    EXPECT_EQ(cudaDeviceSynchronize(), cudaSuccess);
    EXPECT_EQ(own[3], 11);
    EXPECT_EQ(cudaHostUnregister(own.data()), cudaSuccess);
    Quiet quiet;
    EXPECT_EQ(cudaHostUnregister(own.data()), cudaErrorHostMemoryNotRegistered);
}

TEST(ForeignMemory, PitchedRowsAreCopiedAsRectangles) {
    constexpr int width = 5, height = 3;
    std::vector<int> in(width * height), out(width * height);
    for (int i = 0; i < width * height; ++i) in[i] = i;
    char* rows = nullptr;
    size_t pitch = 0, row = width * sizeof(int);
    ASSERT_EQ(cudaMallocPitch(&rows, &pitch, row, height), cudaSuccess);
    EXPECT_GE(pitch, row);
    EXPECT_EQ(pitch % 32, 0u);
    EXPECT_EQ(cudaMemcpy2D(rows, pitch, in.data(), row, row, height, cudaMemcpyHostToDevice),
              cudaSuccess);
    DeviceArray<int> sums(width);
    sum_columns<<<1, 32>>>(rows, pitch, width, height, sums.data());
    EXPECT_EQ(sums.host(), (std::vector<int>{15, 18, 21, 24, 27}));
    EXPECT_EQ(cudaMemset2D(rows, pitch, 0, 8, 2), cudaSuccess);
    EXPECT_EQ(cudaMemcpy2DAsync(out.data(), row, rows, pitch, row, height, cudaMemcpyDefault),
              cudaSuccess);
    EXPECT_EQ(out, (std::vector<int>{0, 0, 2, 3, 4, 0, 0, 7, 8, 9, 10, 11, 12, 13, 14}));
    Quiet quiet;
    EXPECT_EQ(cudaMemcpy2D(rows, 8, in.data(), row, row, 1, cudaMemcpyHostToDevice),
              cudaErrorInvalidPitchValue);
    EXPECT_EQ(cudaMemcpy2D(rows, pitch, in.data(), row, row, 4, cudaMemcpyHostToDevice),
              cudaErrorInvalidValue); // a row too many
    EXPECT_EQ(cudaFree(rows), cudaSuccess);
}

TEST(ForeignMemory, BoxesAreCopiedLayerByLayer) {
    int in[2][3][4], out[2][2][2] = {};
    for (int i = 0; i < 24; ++i) (&in[0][0][0])[i] = i;
    cudaPitchedPtr box;
    ASSERT_EQ(cudaMalloc3D(&box, make_cudaExtent(4 * sizeof(int), 3, 2)), cudaSuccess);
    cudaMemcpy3DParms copy = {};
    copy.srcPtr = make_cudaPitchedPtr(in, 4 * sizeof(int), 4, 3);
    copy.dstPtr = box;
    copy.extent = make_cudaExtent(4 * sizeof(int), 3, 2);
    copy.kind = cudaMemcpyHostToDevice;
    ASSERT_EQ(cudaMemcpy3D(&copy), cudaSuccess);
    copy = {};
    copy.srcPtr = box;
    copy.srcPos = make_cudaPos(1 * sizeof(int), 1, 0);
    copy.dstPtr = make_cudaPitchedPtr(out, 2 * sizeof(int), 2, 2);
    copy.extent = make_cudaExtent(2 * sizeof(int), 2, 2);
    copy.kind = cudaMemcpyDeviceToHost;
    ASSERT_EQ(cudaMemcpy3D(&copy), cudaSuccess);
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 2; ++x) EXPECT_EQ(out[z][y][x], in[z][y + 1][x + 1]);
    EXPECT_EQ(cudaFree(box.ptr), cudaSuccess);
}

TEST(ForeignDevice, AttributesAgreeWithProperties) {
    cudaDeviceProp properties;
    ASSERT_EQ(cudaGetDeviceProperties(&properties, 0), cudaSuccess);
    auto attribute = [](cudaDeviceAttr name) {
        int value = -1;
        EXPECT_EQ(cudaDeviceGetAttribute(&value, name, 0), cudaSuccess);
        return value;
    };
    EXPECT_EQ(attribute(cudaDevAttrWarpSize), 32);
    EXPECT_EQ(attribute(cudaDevAttrMaxThreadsPerBlock), 1024);
    EXPECT_EQ(attribute(cudaDevAttrMultiProcessorCount), properties.multiProcessorCount);
    EXPECT_EQ(attribute(cudaDevAttrComputeCapabilityMajor), properties.major);
    EXPECT_EQ(attribute(cudaDevAttrMaxBlockDimZ), 64);
    EXPECT_EQ(attribute(cudaDevAttrComputeMode), cudaComputeModeDefault);
    EXPECT_EQ(attribute(cudaDevAttrMaxSharedMemoryPerBlock), 49152);
    size_t free_bytes = 0, all = 0;
    EXPECT_EQ(cudaMemGetInfo(&free_bytes, &all), cudaSuccess);
    EXPECT_GT(free_bytes, 0u);
    EXPECT_LE(free_bytes, all);
    int runtime = 0, driver = 0;
    EXPECT_EQ(cudaRuntimeGetVersion(&runtime), cudaSuccess);
    EXPECT_EQ(cudaDriverGetVersion(&driver), cudaSuccess);
    EXPECT_EQ(runtime, CUDART_VERSION);
    EXPECT_GE(driver, runtime);
}

TEST(ForeignDevice, SettingsAreAcceptedAndRemembered) {
    size_t value = 0;
    EXPECT_EQ(cudaDeviceSetLimit(cudaLimitMallocHeapSize, 1 << 24), cudaSuccess);
    EXPECT_EQ(cudaDeviceGetLimit(&value, cudaLimitMallocHeapSize), cudaSuccess);
    EXPECT_EQ(value, size_t(1) << 24);
    EXPECT_EQ(cudaDeviceSetCacheConfig(cudaFuncCachePreferL1), cudaSuccess);
    EXPECT_EQ(cudaFuncSetCacheConfig(increment, cudaFuncCachePreferShared), cudaSuccess);
    EXPECT_EQ(cudaSetDeviceFlags(cudaDeviceMapHost), cudaSuccess);
    EXPECT_EQ(cudaThreadSynchronize(), cudaSuccess);
    EXPECT_EQ(cudaProfilerStart(), cudaSuccess);
    int can = -1, least = -1, greatest = 1;
    EXPECT_EQ(cudaDeviceCanAccessPeer(&can, 0, 0), cudaSuccess);
    EXPECT_EQ(can, 0);
    EXPECT_EQ(cudaDeviceGetStreamPriorityRange(&least, &greatest), cudaSuccess);
    EXPECT_LE(greatest, least);
}

TEST(ForeignDevice, KernelsHaveAttributesAndOccupancy) {
    cudaFuncAttributes attributes;
    ASSERT_EQ(cudaFuncGetAttributes(&attributes, increment), cudaSuccess);
    EXPECT_EQ(attributes.maxThreadsPerBlock, 1024);
    EXPECT_EQ(attributes.maxDynamicSharedSizeBytes, 49152);
    int blocks = 0, grid = 0, block = 0;
    EXPECT_EQ(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&blocks, increment, 128, 0),
              cudaSuccess);
    EXPECT_GE(blocks, 1);
    EXPECT_EQ(cudaOccupancyMaxPotentialBlockSize(&grid, &block, increment, 0, 0), cudaSuccess);
    EXPECT_EQ(block % 32, 0);
}

TEST(ForeignStreams, DoTheirWorkInTheOrderOfTheCalls) {
    cudaStream_t stream;
    ASSERT_EQ(cudaStreamCreateWithPriority(&stream, cudaStreamNonBlocking, -1), cudaSuccess);
    int *device = nullptr, host = 0, seen = 0;
    ASSERT_EQ(cudaMallocAsync(&device, sizeof(int), stream), cudaSuccess);
    EXPECT_EQ(cudaMemsetAsync(device, 0, sizeof(int), stream), cudaSuccess);
    increment<<<1, 1, 0, stream>>>(device, 1);
    EXPECT_EQ(cudaMemcpyAsync(&host, device, 4, cudaMemcpyDeviceToHost, stream), cudaSuccess);
    struct Both {
        int *host, *seen;
    } both{&host, &seen};
    EXPECT_EQ(cudaStreamAddCallback(
                  stream,
                  [](cudaStream_t, cudaError_t status, void* data) {
                      auto both = static_cast<Both*>(data);
                      *both->seen = *both->host + status;
                  },
                  &both, 0),
              cudaSuccess);
    int* twin = nullptr;
    ASSERT_EQ(cudaMallocAsync(&twin, sizeof(int), stream), cudaSuccess);
    EXPECT_EQ(cudaMemcpyPeerAsync(twin, 0, device, 0, sizeof(int), stream), cudaSuccess);
    EXPECT_EQ(cudaMemcpyAsync(&host, twin, 4, cudaMemcpyDeviceToHost, stream), cudaSuccess);
    EXPECT_EQ(host, 1);
    EXPECT_EQ(cudaFreeAsync(twin, stream), cudaSuccess);
    cudaStreamAttrValue attribute = {};
    attribute.accessPolicyWindow.base_ptr = device;
    attribute.accessPolicyWindow.hitProp = cudaAccessPropertyPersisting;
    EXPECT_EQ(cudaStreamSetAttribute(stream, cudaStreamAttributeAccessPolicyWindow, &attribute),
              cudaSuccess);
    EXPECT_EQ(cudaCtxResetPersistingL2Cache(), cudaSuccess);
    EXPECT_EQ(cudaFreeAsync(device, stream), cudaSuccess);
    EXPECT_EQ(cudaStreamSynchronize(stream), cudaSuccess);
    EXPECT_EQ(seen, 1);
    EXPECT_EQ(cudaLaunchHostFunc(
                  stream, [](void* data) { *static_cast<int*>(data) = 5; }, &seen),
              cudaSuccess);
    EXPECT_EQ(seen, 5);
    EXPECT_EQ(cudaStreamDestroy(stream), cudaSuccess);
}
