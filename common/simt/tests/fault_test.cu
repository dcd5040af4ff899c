// What the processor refuses in a kernel is a fault with thread and advice, and the program goes
// on. Under a sanitizer the program ends with its first error: there `raylab run` tests it.
#include "common/simt/tests/settings.h"

#if !defined(RAYLAB_CHECK)

#include <cassert>
#include <cstdlib>

namespace raylab::simt {

namespace {

__global__ void store(int* p, int index) { p[index] = int(threadIdx.x); }

__global__ void divide(int* p, int by) {
    if (threadIdx.x == 5) p[0] = 7 / by;
}

__global__ void overrun_shared(int* p, int index) {
    extern __shared__ int words[];
    words[index] = 1;
    p[0] = words[index];
}

__device__ int deeper(volatile int* p, int n) {
    volatile int frame[100] = {n};
    return n < 0 ? 0 : deeper(frame, n + 1) + frame[n % 100] + p[0];
}
__global__ void recurse(int* p) { p[0] = deeper(p, 1); }

__global__ void asserts(int n) { assert(int(threadIdx.x) < n); }

__global__ void aborts() { std::abort(); }

__global__ void reads_lane(float* out, int lane) {
    out[threadIdx.x] = __shfl_sync(0xffffffff, 1.0f, lane);
}

class Faults : public testing::Test {
  protected:
    void SetUp() override { set_options({.threads = 2, .print_reports = false}); }
    void TearDown() override {
        cudaDeviceReset();
        set_options({});
    }
    static void expect(cudaError_t code, const std::vector<std::string>& words) {
        EXPECT_EQ(cudaDeviceSynchronize(), code) << last_report();
        for (const std::string& word : words)
            EXPECT_NE(last_report().find(word), std::string::npos)
                << "should say: " << word << "\nsaid: " << last_report();
    }
    static int* ints(size_t count) {
        int* p = nullptr;
        EXPECT_EQ(cudaMalloc(&p, count * sizeof(int)), cudaSuccess);
        return p;
    }
};

TEST_F(Faults, ANullPointer) {
    store<<<1, 32>>>(nullptr, 3);
    expect(cudaErrorIllegalAddress, {"null pointer: address 0xc is written", "kernel store",
                                     "block (0,0,0), thread (0,0,0)", "cudaMalloc()"});
}

TEST_F(Faults, AWildAddressTellsTheNearestAllocation) {
    store<<<1, 1>>>(ints(4), 1 << 30);
    expect(cudaErrorIllegalAddress, {"wild address", "4294967280 bytes after the 16 bytes"});
}

TEST_F(Faults, ADivisionByZero) {
    divide<<<1, 32>>>(ints(1), 0);
#if defined(__aarch64__) // whose quotient is 0, and no fault
    expect(cudaSuccess, {});
#else
    expect(cudaErrorLaunchFailure, {"division by zero", "thread (5,0,0)"});
#endif
}

TEST_F(Faults, AnOverrunOfDynamicSharedMemory) {
    overrun_shared<<<1, 1, 64>>>(ints(1), 15);
    expect(cudaSuccess, {});
    overrun_shared<<<1, 1, 64>>>(ints(1), 16);
    expect(cudaErrorIllegalAddress, {"overrun of dynamic shared memory: byte 64 of 64 is written"});
}

TEST_F(Faults, ARecursionWithoutEnd) {
    recurse<<<1, 1>>>(ints(1));
    expect(cudaErrorIllegalAddress, {"stack overflow", "recursion"});
}

TEST_F(Faults, AnAssertionNamesItsThread) {
    const int line = 32;
    asserts<<<1, 64>>>(60);
    expect(cudaErrorAssert, {"fault_test.cu:" + std::to_string(line) + ": error: assertion failed",
                             "int(threadIdx.x) < n", "thread (60,0,0)"});
}

TEST_F(Faults, AnAbort) {
    aborts<<<1, 1>>>();
    expect(cudaErrorLaunchFailure, {"abort() was called"});
}

TEST_F(Faults, AfterAResetEverythingWorksAgain) {
    for (int i = 0; i < 3; ++i) {
        store<<<64, 64>>>(nullptr, 0);
        expect(cudaErrorIllegalAddress, {"null pointer"});
        cudaDeviceReset();
        int* p = ints(1);
        store<<<1, 1>>>(p, 0);
        expect(cudaSuccess, {});
    }
}

TEST_F(Faults, AFreedPointerIsCalledFreed) {
    int* p = ints(4);
    cudaFree(p);
    const std::string line = std::to_string(__LINE__ - 1);
    store<<<1, 1>>>(p, 0);
    expect(cudaErrorIllegalAddress, {"kernel store is given a freed pointer as argument 1",
                                     "freed at", "fault_test.cu:" + line});
}

TEST_F(Faults, ATooLargeAllocationIsRefused) {
    int* p = nullptr;
    EXPECT_EQ(cudaMalloc(&p, size_t(1) << 50), cudaErrorMemoryAllocation);
    EXPECT_EQ(p, nullptr);
}

TEST_F(Faults, AShuffleFromALaneThatIsNotThereGoesOn) {
    float* out = nullptr;
    ASSERT_EQ(cudaMalloc(&out, 64 * sizeof(float)), cudaSuccess);
    testing::internal::CaptureStderr();
    set_options({.threads = 1});
    reads_lane<<<1, 48>>>(out, 20);
    EXPECT_EQ(cudaDeviceSynchronize(), cudaSuccess);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("bad source: __shfl_sync() reads lane 20"), std::string::npos) << said;
    EXPECT_NE(said.find("only 16 lanes"), std::string::npos) << said;
}

} // namespace

} // namespace raylab::simt

#endif
