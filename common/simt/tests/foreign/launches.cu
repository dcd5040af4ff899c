// Launches as foreign programs write them; this file is rewritten with `simt_rewrite --tree`.
#include "launches.cuh"

#include "common/simt/tests/settings.h"

using namespace raylab::simt;

#include <cassert>

#if 0
#include <cublas_v2.h>
#endif

namespace {

__global__ void claims(int* out) {
    assert(threadIdx.x != 7 || blockIdx.x != 1);
    out[blockIdx.x * blockDim.x + threadIdx.x] = 1;
}

} // namespace

TEST(ForeignLaunch, TakesDefaultArgumentsOfTheKernel) {
    DeviceArray<int> out(4);
    scale<<<1, 4>>>(out.data());
    EXPECT_EQ(out.host(), (std::vector<int>{1, 7, 13, 19}));
    scale<<<1, 4>>>(out.data(), 1);
    EXPECT_EQ(out.host(), (std::vector<int>{1, 3, 5, 7}));
    scale<<<1, 4>>>(out.data(), 1, 0);
    EXPECT_EQ(out.host(), (std::vector<int>{0, 2, 4, 6}));
}

TEST(ForeignLaunch, MayStandInAHeaderWithSpacesAndSharedMemoryOutsideOfFunctions) {
    DeviceArray<float> values({1, 2, 3, 4});
    launch_reverse(values.data(), 4);
    EXPECT_EQ(values.host(), (std::vector<float>{4, 3, 2, 1}));
}

TEST(ForeignLaunch, DynamicSharedMemoryMayBeOneVariable) {
    DeviceArray<int> out(3);
    shared_number<<<1, 3, sizeof(int)>>>(out.data());
    EXPECT_EQ(out.host(), (std::vector<int>{42, 42, 42}));
}

// nvcc copies the bytes of an argument to the GPU: the host's copies are constructed and destroyed,
// and a kernel's are neither.
TEST(ForeignLaunch, ArgumentsWithConstructorsArriveAsBytes) {
    for_each_setting([] {
        DeviceArray<int> out(32), alive(1);
        {
            Counted counted(out.data());
            takes_counted<<<1, 32>>>(100, counted, alive.data());
            auto got = out.host();
            for (int i = 0; i < 32; ++i) EXPECT_EQ(got[i], 100 + i);
            EXPECT_EQ(Counted::alive, 1);
            EXPECT_EQ(alive.host()[0], 2); // ours, and the parameter of the launch
        }
        EXPECT_EQ(Counted::alive, 0);
    });
}

TEST(ForeignLaunch, ByAddressTakesTheKernelAsItIsOrCast) {
    DeviceArray<int> out(2);
    int *data = out.data(), factor = 5, offset = 2;
    void* arguments[] = {&data, &factor, &offset};
    EXPECT_EQ(cudaLaunchKernel((void*)scale, dim3(1), dim3(2), arguments, 0, 0), cudaSuccess);
    EXPECT_EQ(out.host(), (std::vector<int>{2, 12}));
    factor = 6;
    EXPECT_EQ(cudaLaunchKernel(reinterpret_cast<const void*>(scale), 1, 2, arguments), cudaSuccess);
    EXPECT_EQ(out.host(), (std::vector<int>{2, 14}));
    offset = 0;
    EXPECT_EQ(cudaLaunchKernel(scale, 1, 2, arguments), cudaSuccess);
    EXPECT_EQ(out.host(), (std::vector<int>{0, 12}));
}

#if defined(__GLIBC__)
TEST(ForeignLaunch, AssertNamesTheThread) {
    set_options({.print_reports = false});
    DeviceArray<int> out(64);
    claims<<<2, 32>>>(out.data());
    EXPECT_EQ(cudaDeviceSynchronize(), cudaErrorAssert);
    std::string report = last_report();
    for (const char* words : {"launches.cu:", "assertion failed: threadIdx.x != 7",
                              "thread (7,0,0)", "block (1,0,0)", "kernel claims"})
        EXPECT_NE(report.find(words), report.npos) << report;
    cudaDeviceReset();
    set_options({});
}
#endif
