// Memory, symbols, streams, events and errors behave as CUDA's manual says, on both machines.
#include "common/simt/tests/settings.h"

#include <cstdint>
#include <cstring>

using namespace raylab::simt;

namespace {

__constant__ float weights[4];
__device__ int counter;

__global__ void weigh(float* out) { out[threadIdx.x] = weights[threadIdx.x] * 2; }
__global__ void count() { atomicAdd(&counter, 1); }
__global__ void through_pointer(int* p) { *p += 10; }
__global__ void vectors(float4* out) {
    float2 a = make_float2(1, 2);
    int3 b = make_int3(3, 4, 5);
    uchar4 c = make_uchar4(6, 7, 8, 255);
    out[0] = make_float4(a.x + b.x, a.y + b.y, float(b.z + c.x), float(c.w));
}

} // namespace

TEST(Memory, IsAlignedAndKeepsWhatIsCopied) {
    int *a = nullptr, *b = nullptr;
    std::vector<int> in(1000), out(1000);
    for (int i = 0; i < 1000; ++i) in[i] = i * i;
    ASSERT_EQ(cudaMalloc(&a, 4000), cudaSuccess);
    ASSERT_EQ(cudaMalloc((void**)&b, 4000), cudaSuccess);
    EXPECT_EQ(reinterpret_cast<uintptr_t>(a) % 256, 0u);
    EXPECT_EQ(cudaMemcpy(a, in.data(), 4000, cudaMemcpyHostToDevice), cudaSuccess);
    EXPECT_EQ(cudaMemcpy(b, a, 4000, cudaMemcpyDeviceToDevice), cudaSuccess);
    EXPECT_EQ(cudaMemcpyAsync(out.data() + 10, b + 10, 3960, cudaMemcpyDefault), cudaSuccess);
    EXPECT_EQ(cudaDeviceSynchronize(), cudaSuccess);
    for (int i = 0; i < 1000; ++i) EXPECT_EQ(out[i], i < 10 ? 0 : in[i]);
    EXPECT_EQ(cudaMemset(a, 0x11, 8), cudaSuccess);
    EXPECT_EQ(cudaMemcpy(out.data(), a, 12, cudaMemcpyDeviceToHost), cudaSuccess);
    EXPECT_EQ(out[1], 0x11111111);
    EXPECT_EQ(out[2], 4);
    EXPECT_EQ(cudaFree(a), cudaSuccess);
    EXPECT_EQ(cudaFree(b), cudaSuccess);
    EXPECT_EQ(cudaFree(nullptr), cudaSuccess);
}

TEST(Memory, PinnedHostMemoryIsForBoth) {
    int* p = nullptr;
    ASSERT_EQ(cudaMallocHost(&p, sizeof(int)), cudaSuccess);
    *p = 5;
    through_pointer<<<1, 1>>>(p);
    EXPECT_EQ(cudaDeviceSynchronize(), cudaSuccess);
    EXPECT_EQ(*p, 15);
    EXPECT_EQ(cudaFreeHost(p), cudaSuccess);
}

TEST(Symbols, AreReachedByNameAndByAddress) {
    float in[4] = {1, 2, 3, 4}, back[2];
    ASSERT_EQ(cudaMemcpyToSymbol(weights, in, sizeof in), cudaSuccess);
    ASSERT_EQ(cudaMemcpyToSymbol(weights, in, 4, 12), cudaSuccess); // the last becomes 1
    DeviceArray<float> out(4);
    weigh<<<1, 4>>>(out.data());
    EXPECT_EQ(out.host(), (std::vector<float>{2, 4, 6, 2}));
    ASSERT_EQ(cudaMemcpyFromSymbol(back, weights, 8, 4), cudaSuccess);
    EXPECT_EQ(back[0], 2);
    EXPECT_EQ(back[1], 3);

    int value = 7;
    void* address = nullptr;
    ASSERT_EQ(cudaMemcpyToSymbol(counter, &value, sizeof value), cudaSuccess);
    count<<<2, 50>>>();
    ASSERT_EQ(cudaGetSymbolAddress(&address, counter), cudaSuccess);
    through_pointer<<<1, 1>>>(static_cast<int*>(address));
    ASSERT_EQ(cudaMemcpyFromSymbol(&value, counter, sizeof value), cudaSuccess);
    EXPECT_EQ(value, 117);
    size_t bytes = 0;
    ASSERT_EQ(cudaGetSymbolSize(&bytes, weights), cudaSuccess);
    EXPECT_EQ(bytes, 16u);
}

TEST(VectorTypes, HaveTheirMembersAndAlignment) {
    EXPECT_EQ(sizeof(float3), 12u);
    EXPECT_EQ(alignof(float3), 4u);
    EXPECT_EQ(alignof(float2), 8u);
    EXPECT_EQ(alignof(float4), 16u);
    EXPECT_EQ(alignof(int4), 16u);
    EXPECT_EQ(alignof(double2), 16u);
    EXPECT_EQ(alignof(uchar4), 4u);
    EXPECT_EQ(sizeof(ulonglong2), 16u);
    DeviceArray<float4> out(1);
    vectors<<<1, 1>>>(out.data());
    float4 v = out.host()[0];
    EXPECT_EQ(v.x, 4);
    EXPECT_EQ(v.y, 6);
    EXPECT_EQ(v.z, 11);
    EXPECT_EQ(v.w, 255);
}

TEST(Events, MeasureWhatLiesBetweenThem) {
    cudaStream_t stream;
    cudaEvent_t start, end;
    ASSERT_EQ(cudaStreamCreate(&stream), cudaSuccess);
    ASSERT_EQ(cudaEventCreate(&start), cudaSuccess);
    ASSERT_EQ(cudaEventCreate(&end), cudaSuccess);
    DeviceArray<int> out(1);
    ASSERT_EQ(cudaEventRecord(start, stream), cudaSuccess);
    through_pointer<<<1, 1, 0, stream>>>(out.data());
    ASSERT_EQ(cudaEventRecord(end, stream), cudaSuccess);
    ASSERT_EQ(cudaEventSynchronize(end), cudaSuccess);
    EXPECT_EQ(cudaEventQuery(end), cudaSuccess);
    EXPECT_EQ(cudaStreamQuery(stream), cudaSuccess);
    float milliseconds = -1;
    ASSERT_EQ(cudaEventElapsedTime(&milliseconds, start, end), cudaSuccess);
    EXPECT_GE(milliseconds, 0);
    EXPECT_LT(milliseconds, 60000);
    EXPECT_EQ(cudaEventDestroy(start), cudaSuccess);
    EXPECT_EQ(cudaEventDestroy(end), cudaSuccess);
    EXPECT_EQ(cudaStreamSynchronize(stream), cudaSuccess);
    EXPECT_EQ(cudaStreamDestroy(stream), cudaSuccess);
    EXPECT_EQ(out.host()[0], 10);
}

TEST(Device, IsThereAndSaysWhatItIs) {
    int devices = 0, device = -1;
    ASSERT_EQ(cudaGetDeviceCount(&devices), cudaSuccess);
    EXPECT_GE(devices, 1);
    ASSERT_EQ(cudaSetDevice(0), cudaSuccess);
    ASSERT_EQ(cudaGetDevice(&device), cudaSuccess);
    EXPECT_EQ(device, 0);
    cudaDeviceProp properties;
    ASSERT_EQ(cudaGetDeviceProperties(&properties, 0), cudaSuccess);
    EXPECT_EQ(properties.warpSize, 32);
    EXPECT_EQ(properties.maxThreadsPerBlock, 1024);
    EXPECT_GE(properties.multiProcessorCount, 1);
    EXPECT_EQ(cudaSetDevice(1000), cudaErrorInvalidDevice);
    EXPECT_EQ(cudaGetLastError(), cudaErrorInvalidDevice);
}

TEST(Errors, HaveCudasNamesAndWords) {
    EXPECT_STREQ(cudaGetErrorName(cudaErrorInvalidValue), "cudaErrorInvalidValue");
    EXPECT_STREQ(cudaGetErrorString(cudaErrorInvalidValue), "invalid argument");
    EXPECT_STREQ(cudaGetErrorString(cudaErrorInvalidConfiguration),
                 "invalid configuration argument");
    EXPECT_STREQ(cudaGetErrorString(cudaErrorLaunchFailure), "unspecified launch failure");
    EXPECT_STREQ(cudaGetErrorString(cudaSuccess), "no error");
}

TEST(Check, NamesTheCallThePlaceAndTheError) {
    EXPECT_NO_THROW(check(cudaSuccess, "cudaMalloc"));
    try {
        check(cudaErrorMemoryAllocation, "cudaMalloc(pixels)");
        FAIL() << "an error went unnoticed";
    } catch (const DeviceError& error) {
        std::string text = error.what();
        EXPECT_EQ(error.code, cudaErrorMemoryAllocation);
        EXPECT_NE(text.find("runtime_test.cu:" + std::to_string(__LINE__ - 5)), text.npos) << text;
        EXPECT_NE(text.find("cudaMalloc(pixels) failed: out of memory"), text.npos) << text;
    }
}

TEST(Check, SaysInPlainWordsThatThereIsNoGpu) {
    for (cudaError_t error : {cudaErrorInsufficientDriver, cudaErrorNoDevice}) {
        try {
            check(error, "cudaMalloc");
            FAIL() << "an error went unnoticed";
        } catch (const DeviceError& thrown) {
            std::string text = thrown.what();
            EXPECT_NE(text.find("no NVIDIA GPU or driver"), text.npos) << text;
            EXPECT_NE(text.find("use the CPU machine"), text.npos) << text;
        }
    }
}
