// Every way to write a launch, and what the threads then know about themselves.
#include "common/simt/tests/settings.h"

using namespace raylab::simt;

namespace {

__global__ void where_am_i(uint3* threads, uint3* blocks) {
    int thread = (threadIdx.z * blockDim.y + threadIdx.y) * blockDim.x + threadIdx.x;
    int block = (blockIdx.z * gridDim.y + blockIdx.y) * gridDim.x + blockIdx.x;
    int i = block * int(blockDim.x * blockDim.y * blockDim.z) + thread;
    threads[i] = make_uint3(threadIdx.x, threadIdx.y, threadIdx.z);
    blocks[i] = make_uint3(blockIdx.x, blockIdx.y, blockIdx.z);
}

__global__ void add(int* out, int a, float b) { atomicAdd(out, a + int(b)); }

template <class T> __global__ void add_value(T* out, T value) { atomicAdd(out, value); }

template <int factor, class T> __global__ void add_scaled(T* out, const T* in, const int* unused) {
    atomicAdd(out, factor * *in + (unused ? 1 : 0));
}

struct Offset {
    int value;
    __host__ __device__ int operator()(int x) const { return x + value; }
};

template <class Function, int times> __global__ void apply(int* out, Function function) {
    for (int i = 0; i < times; ++i) *out = function(*out);
}

__global__ void overloaded(int* out) { *out = 1; }
__global__ void overloaded(float* out) { *out = 2; }

// A kernel may change its parameters: they are the thread's own.
__global__ void own_parameters(int* out, int3 p) {
    p.x += threadIdx.x;
    atomicAdd(out, p.x);
}

__global__ void fill_shared(double* out, int n) {
    extern __shared__ __align__(16) unsigned char bytes[];
    auto values = reinterpret_cast<double*>(bytes);
    for (int i = threadIdx.x; i < n; i += blockDim.x) values[i] = blockIdx.x + 0.5 * i;
    __syncthreads();
    if (threadIdx.x == 0)
        for (int i = 0; i < n; ++i) out[blockIdx.x] += values[i];
}

// Two-dimensional static shared memory, and a dynamic one seen as rows.
__global__ void transpose(const float* in, float* out) {
    __shared__ float tile[16][17];
    extern __shared__ float rows[][16];
    tile[threadIdx.y][threadIdx.x] = in[threadIdx.y * 16 + threadIdx.x];
    __syncthreads();
    rows[threadIdx.y][threadIdx.x] = tile[threadIdx.x][threadIdx.y];
    out[threadIdx.y * 16 + threadIdx.x] = rows[threadIdx.y][threadIdx.x];
}

namespace inner {
struct Host {
    void (*kernel)(int*, int, float) = add;
    void launch(int* out) const { kernel<<<1, 2>>>(out, 1, 0.0f); }
};
} // namespace inner

} // namespace

TEST(Launch, ThreadsAndBlocksKnowTheirPlace) {
    for_each_setting([] {
        dim3 grid(3, 2, 2), block(4, 3, 5);
        int n = 12 * 60;
        DeviceArray<uint3> threads(n), blocks(n);
        where_am_i<<<grid, block>>>(threads.data(), blocks.data());
        auto t = threads.host(), b = blocks.host();
        for (int i = 0; i < n; ++i) {
            int in_block = i % 60, of_grid = i / 60;
            ASSERT_EQ(t[i].x, in_block % 4);
            ASSERT_EQ(t[i].y, in_block / 4 % 3);
            ASSERT_EQ(t[i].z, in_block / 12);
            ASSERT_EQ(b[i].x, of_grid % 3);
            ASSERT_EQ(b[i].y, of_grid / 3 % 2);
            ASSERT_EQ(b[i].z, of_grid / 6);
        }
    });
}

TEST(Launch, ArgumentsConvertToTheParameters) {
    DeviceArray<int> out(1);
    short a = 3;
    add<<<2, 4>>>(out.data(), a, 2); // short to int, int to float
    EXPECT_EQ(out.host()[0], 8 * 5);
    add_scaled<2, int><<<1, 1>>>(out.data(), out.data(), 0);
    EXPECT_EQ(out.host()[0], 3 * 40);
    add_scaled<2, int><<<1, 1>>>(out.data(), out.data(), nullptr);
    EXPECT_EQ(out.host()[0], 9 * 40);
}

TEST(Launch, TemplateArgumentsAreGivenOrDeduced) {
    DeviceArray<int> out(1);
    DeviceArray<double> precise(1, 0.5);
    add_value<<<1, 3>>>(out.data(), 2);
    add_value<int><<<1, 3>>>(out.data(), 2);
    add_value<<<1, 4>>>(precise.data(), 0.25);
    EXPECT_EQ(out.host()[0], 12);
    EXPECT_EQ(precise.host()[0], 1.5);
    apply<Offset, 3><<<1, 1>>>(out.data(), Offset{5});
    EXPECT_EQ(out.host()[0], 27);
}

TEST(Launch, TheArgumentsChooseAmongOverloads) {
    DeviceArray<int> i(1);
    DeviceArray<float> f(1);
    overloaded<<<1, 1>>>(i.data());
    overloaded<<<1, 1>>>(f.data());
    EXPECT_EQ(i.host()[0], 1);
    EXPECT_EQ(f.host()[0], 2);
}

TEST(Launch, KernelsCanBePointersMembersAndTables) {
    DeviceArray<int> out(1);
    void (*table[])(int*, int, float) = {add, add};
    auto pointer = add;
    auto choose = [&](int i) { return table[i]; };
    inner::Host host, *at = &host;
    pointer<<<1, 1>>>(out.data(), 1, 0);
    table[1]<<<1, 1>>>(out.data(), 10, 0);
    (choose(0))<<<1, 1>>>(out.data(), 100, 0);
    choose(1)<<<1, 1>>>(out.data(), 1000, 0);
    host.kernel<<<1, 1>>>(out.data(), 10000, 0);
    at->kernel<<<1, 1>>>(out.data(), 100000, 0);
    if (out.data()) (*pointer)<<<1, 1>>>(out.data(), 1000000, 0);
    EXPECT_EQ(out.host()[0], 1111111);
    host.launch(out.data());
    EXPECT_EQ(out.host()[0], 1111113);
}

TEST(Launch, MayBeSpreadOverLinesAndMacros) {
#define LAUNCH(kernel, threads) kernel<<<1, (threads)>>>(out.data(), 1, 0)
    DeviceArray<int> out(1);
    LAUNCH(add, 5);
    add            // a comment
        <<<dim3(2, // with >>> in it
                1),
           /* and <<< here */ 3>>>(
            out.data(),
            [&] {
                add<<<1, 1>>>(out.data(), 100, 0); // inside an argument
                return 1;
            }(),
            0);
    EXPECT_EQ(out.host()[0], 5 + 100 + 6);
}

TEST(Launch, EachThreadOwnsItsParameters) {
    for_each_setting([] {
        DeviceArray<int> out(1);
        own_parameters<<<2, 32>>>(out.data(), make_int3(1, 0, 0));
        EXPECT_EQ(out.host()[0], 2 * (32 + 31 * 32 / 2));
    });
}

TEST(Launch, EachBlockHasItsDynamicSharedMemory) {
    for_each_setting([] {
        for (int n : {1, 5, 6144}) { // up to 48 KiB
            DeviceArray<double> out(6);
            fill_shared<<<6, 64, n * sizeof(double)>>>(out.data(), n);
            auto got = out.host();
            for (int b = 0; b < 6; ++b) ASSERT_EQ(got[b], n * b + 0.25 * n * (n - 1));
        }
        std::vector<float> in(256), want(256);
        for (int i = 0; i < 256; ++i) want[i % 16 * 16 + i / 16] = in[i] = float(i);
        DeviceArray<float> from(in), to(256);
        transpose<<<1, dim3(16, 16), 1024>>>(from.data(), to.data());
        EXPECT_EQ(to.host(), want);
    });
}

TEST(Launch, MoreThan48KiBMustBeAskedFor) {
    constexpr int bytes = 64 << 10;
    DeviceArray<double> out(1);
    ASSERT_EQ(cudaFuncSetAttribute(fill_shared, cudaFuncAttributeMaxDynamicSharedMemorySize, bytes),
              cudaSuccess);
    fill_shared<<<1, 64, bytes>>>(out.data(), bytes / 8);
    EXPECT_EQ(out.host()[0], 0.25 * (bytes / 8) * (bytes / 8 - 1));
}

TEST(Launch, ImpossibleShapesAreRefusedAndForgottenOnceAsked) {
    DeviceArray<int> out(1);
    struct Shape {
        dim3 grid, block;
    };
    for (Shape shape :
         {Shape{0, 1}, Shape{1, 0}, Shape{dim3(1, 0), 1}, Shape{1, 1025}, Shape{1, dim3(32, 33)},
          Shape{1, dim3(1, 1, 65)}, Shape{dim3(1, 65536), 1}, Shape{dim3(1, 1, 65536), 1}}) {
        add<<<shape.grid, shape.block>>>(out.data(), 1, 0);
        EXPECT_EQ(cudaPeekAtLastError(), cudaErrorInvalidConfiguration);
        EXPECT_EQ(cudaGetLastError(), cudaErrorInvalidConfiguration);
        EXPECT_EQ(cudaGetLastError(), cudaSuccess);
    }
    EXPECT_EQ(out.host()[0], 0);
}
