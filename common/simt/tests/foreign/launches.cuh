// A header as foreign programs have them: with kernels, a launch and dynamic shared memory.
#ifndef LAUNCHES_CUH
#define LAUNCHES_CUH

extern __shared__ float pool[]; // outside of functions, as the programming guide has it

static __inline__ __device__ __forceinline__ int twice(int x) { return 2 * x; }

__global__ void scale(int* out, int factor = 3, int offset = 1) {
    out[threadIdx.x] = twice(threadIdx.x) * factor + offset;
}

__global__ void reverse(float* values) {
    pool[threadIdx.x] = values[threadIdx.x];
    __syncthreads();
    float* same = (float*)pool;
    values[threadIdx.x] = same[blockDim.x - 1 - threadIdx.x];
}

__global__ void shared_number(int* out) {
    extern __shared__ int number;
    if (threadIdx.x == 0) number = 41;
    __syncthreads();
    out[threadIdx.x] = number + 1;
}

inline void launch_reverse(float* values, int n) {
    // clang-format off
    reverse << <1, n, n * sizeof(float)>> >(values);
    // clang-format on
}

// Counts its constructions and destructions.
struct Counted {
    int* values;
    static inline int alive = 0;
    explicit Counted(int* values) : values(values) { ++alive; }
    Counted(const Counted& other) : values(other.values) { ++alive; }
    ~Counted() {
        --alive;
        values = nullptr;
    }
};

__global__ void takes_counted(int before, Counted counted, int* alive) {
    counted.values[threadIdx.x] = before + threadIdx.x;
    if (threadIdx.x == 0) *alive = Counted::alive;
}

#endif
