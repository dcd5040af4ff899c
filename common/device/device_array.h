// An array in device memory that frees itself. Include from files that nvcc or the CPU machine
// compile.
#pragma once

#include "common/simt/check.h"
#include "common/simt/cuda.h"

#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace raylab {

using simt::check; // throws DeviceError if a CUDA call failed

template <class T> class DeviceArray {
    static_assert(std::is_trivially_copyable_v<T>, "device arrays are copied byte by byte");

  public:
    DeviceArray() = default;

    // n elements, all bytes zero.
    explicit DeviceArray(std::size_t n) : size_(n) {
        if (n == 0) return;
        check(cudaMalloc(reinterpret_cast<void**>(&data_), n * sizeof(T)), "cudaMalloc");
        check(cudaMemset(data_, 0, n * sizeof(T)), "cudaMemset");
    }

    // A copy of host memory.
    explicit DeviceArray(std::span<const T> host) : size_(host.size()) {
        if (host.empty()) return;
        check(cudaMalloc(reinterpret_cast<void**>(&data_), host.size_bytes()), "cudaMalloc");
        check(cudaMemcpy(data_, host.data(), host.size_bytes(), cudaMemcpyHostToDevice),
              "cudaMemcpy");
    }

    ~DeviceArray() { cudaFree(data_); }

    DeviceArray(DeviceArray&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
    DeviceArray& operator=(DeviceArray&& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        return *this;
    }

    // Replaces the contents by as many elements of host memory.
    void assign(std::span<const T> host) {
        check(cudaMemcpy(data_, host.data(), host.size_bytes(), cudaMemcpyHostToDevice),
              "cudaMemcpy");
    }

    // All bytes zero.
    void clear() { check(cudaMemset(data_, 0, size_ * sizeof(T)), "cudaMemset"); }

    T* data() { return data_; }
    const T* data() const { return data_; }
    std::size_t size() const { return size_; }

    // Waits for the kernels launched so far, then copies back.
    std::vector<T> to_host() const {
        std::vector<T> host(size_);
        to_host(0, host);
        return host;
    }

    // The same for the elements from `first` on, as many as `host` has.
    void to_host(std::size_t first, std::span<T> host) const {
        if (!host.empty())
            check(cudaMemcpy(host.data(), data_ + first, host.size_bytes(), cudaMemcpyDeviceToHost),
                  "cudaMemcpy");
    }

  private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

} // namespace raylab
