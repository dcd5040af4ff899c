// Each mistake that the CPU machine can see is reported at its file and line, with the kernel, the
// block and the thread; the correct kernels of the other tests run in silence.
#include "common/simt/tests/settings.h"

#include <gtest/gtest.h>

using namespace raylab::simt;

namespace {

// The lines on which the mistakes stand; device and host share one memory here.
int lines[32];
#define MARK(i) atomicExch(&lines[i], __LINE__)

__global__ void divergent() {
    if (threadIdx.x < 40)
        MARK(0), __syncthreads();
    else
        MARK(1), __syncthreads();
}

#define TWO_BARRIERS(condition)                                                                    \
    if (condition)                                                                                 \
        __syncthreads();                                                                           \
    else                                                                                           \
        __syncthreads()

__global__ void divergent_on_one_line() {
    atomicExch(&lines[2], __LINE__ + 1);
    TWO_BARRIERS(threadIdx.x < 8);
}

__global__ void divergent_in_a_loop() {
    for (int i = 0; i < 1 + (threadIdx.x == 7); ++i) MARK(3), __syncthreads();
}

__global__ void exits_early(int n) {
    if (threadIdx.x >= n) return;
    MARK(4), __syncthreads();
}

__global__ void not_in_mask() { MARK(5), __syncwarp(0x0000ffffu); }

__global__ void lane_exited(int* out) {
    if (threadIdx.x == 5) return;
    MARK(6), *out = __shfl_sync(0xffffffffu, 1, 0);
}

__global__ void different_operations(int* out) {
    if (threadIdx.x < 16)
        MARK(7), *out = __shfl_sync(0xffffffffu, 1, 0);
    else
        MARK(8), *out = __any_sync(0xffffffffu, 1);
}

__global__ void different_masks(int* out) {
    unsigned mask = threadIdx.x < 16 ? 0xffffffffu : 0xffff0001u;
    MARK(9), *out = __ballot_sync(mask, 1);
}

__global__ void warp_waits_for_block() {
    if (threadIdx.x % 32 < 16)
        MARK(10), __syncwarp();
    else
        MARK(11), __syncthreads();
}

__global__ void traps() {
    if (threadIdx.x == 3 && blockIdx.x == 2) MARK(12), __trap();
}

__global__ void launches(int* p);
__global__ void writes(int* p) { *p = 1; }
__global__ void launches(int* p) { MARK(13), writes<<<1, 1>>>(p); }

class Diagnostics : public testing::Test {
  protected:
    void SetUp() override { set_options({.threads = 1, .print_reports = false}); }
    void TearDown() override {
        set_options({});
        cudaDeviceReset();
    }

    // The latest report must name these, among them "file:line" of a mark.
    void expect_report(std::vector<std::string> words) {
        for (const std::string& word : words)
            EXPECT_NE(last_report().find(word), std::string::npos)
                << "expected: " << word << "\nin: " << last_report();
    }
    std::string at(int mark) {
        return "common/simt/tests/diagnostics_test.cu:" + std::to_string(lines[mark]) + ": ";
    }
    void expect_fault(std::vector<std::string> words) {
        EXPECT_EQ(cudaDeviceSynchronize(), cudaErrorLaunchFailure);
        expect_report(words);
    }
};

} // namespace

TEST_F(Diagnostics, DifferentBarriersAreNamedWithWhoWaitsThere) {
    divergent<<<3, 64>>>();
    expect_fault({at(0) + "error: divergent barrier", "kernel divergent, launched at",
                  "block (0,0,0), thread (0,0,0)", at(0) + "40 threads wait at __syncthreads()",
                  at(1) + "24 threads wait at __syncthreads(), the first is thread (40,0,0)",
                  "expected: all threads", "to do: "});
}

TEST_F(Diagnostics, TwoBarriersOnOneLineAreTwoBarriers) {
    divergent_on_one_line<<<1, 32>>>();
    expect_fault({at(2) + "error: divergent barrier", at(2) + "8 threads", at(2) + "24 threads"});
}

TEST_F(Diagnostics, OneMoreRoundThanTheOthersIsAnExitBeforeABarrier) {
    divergent_in_a_loop<<<1, 64>>>();
    expect_fault(
        {at(3) + "error: exit before a barrier", "thread (7,0,0)", "63 threads have returned"});
}

TEST_F(Diagnostics, AnEarlyReturnIsAnExitBeforeABarrier) {
    exits_early<<<dim3(2, 2), dim3(8, 4)>>>(5);
    expect_fault({at(4) + "error: exit before a barrier", "kernel exits_early",
                  "thread (5,0,0) returned", "block (0,0,0), thread (0,0,0)",
                  "12 threads have returned", "20 threads wait"});
}

TEST_F(Diagnostics, ALaneMustBeInItsOwnMask) {
    not_in_mask<<<1, 64>>>();
    expect_fault({at(5) + "error: bad mask: lane 16 calls __syncwarp() with mask 0x0000ffff",
                  "thread (16,0,0)"});
}

TEST_F(Diagnostics, ALaneThatReturnedCannotBeInAMask) {
    DeviceArray<int> out(1);
    lane_exited<<<1, 32>>>(out.data());
    expect_fault({at(6) + "error: bad mask: __shfl_sync() names lane 5, which has returned",
                  "31 threads wait", "1 thread has returned"});
}

TEST_F(Diagnostics, LanesMustBeAtTheSameOperation) {
    DeviceArray<int> out(1);
    different_operations<<<1, 32>>>(out.data());
    expect_fault(
        {at(7) + "error: bad mask: lanes of one warp that name each other are at different",
         at(7) + "16 threads wait at __shfl_sync()", at(8) + "16 threads wait at __any_sync()"});
}

TEST_F(Diagnostics, LanesMustGiveTheSameMask) {
    DeviceArray<int> out(1);
    different_masks<<<1, 32>>>(out.data());
    expect_fault({at(9) + "error: bad mask", "different masks", "0xffffffff", "0xffff0001"});
}

TEST_F(Diagnostics, AWarpThatWaitsForABlockThatWaitsIsADeadlock) {
    warp_waits_for_block<<<1, 32>>>();
    expect_fault({at(10) + "error: deadlock", at(10) + "16 threads", at(11) + "16 threads",
                  "__syncthreads()"});
}

TEST_F(Diagnostics, ATrapNamesItsThread) {
    traps<<<4, 32>>>();
    expect_fault({at(12) + "error: the kernel called __trap()", "block (2,0,0), thread (3,0,0)"});
}

TEST_F(Diagnostics, AFaultStaysUntilTheDeviceIsReset) {
    DeviceArray<int> out(1);
    divergent<<<1, 64>>>();
    writes<<<1, 1>>>(out.data());
    int value = 0, *p = nullptr;
    EXPECT_EQ(cudaMemcpy(&value, out.data(), sizeof value, cudaMemcpyDeviceToHost),
              cudaErrorLaunchFailure);
    EXPECT_EQ(cudaMalloc(&p, 4), cudaErrorLaunchFailure);
    EXPECT_EQ(cudaGetLastError(), cudaErrorLaunchFailure);
    EXPECT_EQ(cudaGetLastError(), cudaErrorLaunchFailure);
    EXPECT_EQ(cudaDeviceReset(), cudaSuccess);
    EXPECT_EQ(cudaGetLastError(), cudaSuccess);
    EXPECT_EQ(last_report(), "");
}

TEST_F(Diagnostics, AfterAResetEverythingWorksAgain) {
    for (int i = 0; i < 3; ++i) {
        divergent<<<1, 1024>>>();
        cudaDeviceReset();
        DeviceArray<int> out(1);
        writes<<<1, 1>>>(out.data());
        EXPECT_EQ(out.host()[0], 1);
    }
}

TEST_F(Diagnostics, CheckThrowsTheWholeStory) {
    divergent<<<1, 64>>>();
    try {
        check(cudaDeviceSynchronize(), "divergent<<<>>>");
        FAIL() << "a fault went unnoticed";
    } catch (const DeviceError& error) {
        EXPECT_NE(std::string(error.what()).find(at(1) + "24 threads"), std::string::npos);
    }
}

TEST_F(Diagnostics, AHostPointerIsNoArgument) {
    int value = 0;
    int line = __LINE__ + 1;
    writes<<<1, 1>>>(&value);
    EXPECT_EQ(cudaDeviceSynchronize(), cudaErrorIllegalAddress);
    expect_report({"diagnostics_test.cu:" + std::to_string(line) +
                   ": error: kernel writes is given a host pointer as argument 1"});
    EXPECT_EQ(value, 0);
}

TEST_F(Diagnostics, AFreedPointerIsNoArgument) {
    int* p = nullptr;
    ASSERT_EQ(cudaMalloc(&p, 4), cudaSuccess);
    cudaFree(p);
    writes<<<1, 1>>>(p);
    EXPECT_EQ(cudaDeviceSynchronize(), cudaErrorIllegalAddress);
}

TEST_F(Diagnostics, KernelsAreLaunchedByTheHost) {
    DeviceArray<int> out(1);
    launches<<<1, 1>>>(out.data());
    EXPECT_EQ(cudaGetLastError(), cudaErrorNotSupported);
    expect_report({at(13) + "error: thread (0,0,0) of block (0,0,0) of kernel launches"});
}

TEST_F(Diagnostics, RefusedLaunchesSayWhy) {
    int line = __LINE__ + 1;
    divergent<<<1, 2048>>>();
    EXPECT_EQ(cudaGetLastError(), cudaErrorInvalidConfiguration);
    expect_report({"diagnostics_test.cu:" + std::to_string(line) +
                       ": error: kernel divergent cannot be launched",
                   "(2048,1,1)", "at most 1024"});
    divergent<<<1, 32, 49153>>>();
    EXPECT_EQ(cudaGetLastError(), cudaErrorInvalidValue);
    expect_report({"49153 bytes", "at most 49152", "cudaFuncSetAttribute"});
}

TEST_F(Diagnostics, CopiesStayInTheirMemoryAndKeepTheirDirection) {
    int *p = nullptr, host[8] = {};
    int line = __LINE__ + 1;
    ASSERT_EQ(cudaMalloc(&p, 16), cudaSuccess);
    EXPECT_EQ(cudaMemcpy(p, host, 20, cudaMemcpyHostToDevice), cudaErrorInvalidValue);
    expect_report({"diagnostics_test.cu:" + std::to_string(line + 1) + ": error: the destination",
                   "the 16 bytes that cudaMalloc() gave at",
                   "diagnostics_test.cu:" + std::to_string(line), "20 bytes"});
    EXPECT_EQ(cudaMemcpy(host, p + 2, 12, cudaMemcpyDeviceToHost), cudaErrorInvalidValue);
    expect_report({"the source is byte 8 of the 16 bytes"});
    EXPECT_EQ(cudaMemcpy(host, p, 16, cudaMemcpyHostToDevice), cudaErrorInvalidValue);
    expect_report({"the destination is not device memory", "direction"});
    EXPECT_EQ(cudaMemcpy(host, p, 16, cudaMemcpyHostToHost), cudaErrorInvalidValue);
    expect_report({"the source is device memory"});
    EXPECT_EQ(cudaMemset(host, 0, 4), cudaErrorInvalidValue);
    EXPECT_EQ(cudaMemset(p, 0, 17), cudaErrorInvalidValue);
    EXPECT_EQ(cudaMemcpy(host, p, 16, cudaMemcpyKind(9)), cudaErrorInvalidMemcpyDirection);
    EXPECT_EQ(cudaFree(p + 1), cudaErrorInvalidValue);
    EXPECT_EQ(cudaFree(host), cudaErrorInvalidValue);
    EXPECT_EQ(cudaFree(p), cudaSuccess);
    EXPECT_EQ(cudaFree(p), cudaErrorInvalidValue);
}

TEST_F(Diagnostics, OptionsOutOfRangeAreRefused) {
    EXPECT_THROW(set_options({.threads = -1}), std::invalid_argument);
    EXPECT_THROW(set_options({.stack_size = 1000}), std::invalid_argument);
}
