// Runs a test under every way that the CPU machine can run a kernel; on a GPU, once.
#pragma once

#include "common/simt/check.h"

#include <gtest/gtest.h>

#include <vector>

namespace raylab::simt {

template <class Test> void for_each_setting(Test test) {
#if defined(RAYLAB_CUDA)
    test();
#else
#if defined(RAYLAB_CHECK)
    constexpr int most_threads = 1; // which is what there are
#else
    constexpr int most_threads = 4;
#endif
    for (Order order : {Order::forward, Order::reverse, Order::random})
        for (int threads = 1; threads <= most_threads; ++threads) {
            SCOPED_TRACE(testing::Message() << "order " << int(order) << ", workers " << threads);
            set_options({.threads = threads, .order = order, .seed = uint64_t(threads)});
            test();
        }
    set_options({});
#endif
}

// ThreadSanitizer takes its time for every CUDA thread: it gets a few sizes only.
#if defined(RAYLAB_CHECK_THREAD)
inline const std::vector<int> block_sizes = {1, 31, 64, 100};
#else
inline const std::vector<int> block_sizes = {1,   2,   3,   31,  32,  33,   63,  64,
                                             100, 128, 255, 256, 511, 1000, 1024};
#endif

// An array in device memory, filled from and read back to the host.
template <class T> class DeviceArray {
  public:
    explicit DeviceArray(size_t count, T value = {}) : DeviceArray(std::vector<T>(count, value)) {}
    explicit DeviceArray(const std::vector<T>& values) : count_(values.size()) {
        check(cudaMalloc(&data_, count_ * sizeof(T)), "cudaMalloc");
        check(cudaMemcpy(data_, values.data(), count_ * sizeof(T), cudaMemcpyHostToDevice), "copy");
    }
    ~DeviceArray() { cudaFree(data_); }
    DeviceArray(const DeviceArray&) = delete;
    DeviceArray& operator=(const DeviceArray&) = delete;

    T* data() { return data_; }
    std::vector<T> host() const {
        std::vector<T> values(count_);
        check(cudaDeviceSynchronize(), "kernel");
        check(cudaMemcpy(values.data(), data_, count_ * sizeof(T), cudaMemcpyDeviceToHost), "copy");
        return values;
    }

  private:
    T* data_ = nullptr;
    size_t count_;
};

} // namespace raylab::simt
