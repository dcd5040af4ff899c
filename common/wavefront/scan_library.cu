// Scan by the library: CUB, which comes with CUDA, or the C++ standard library on the CPU machine.
//
// In work that is not a lesson this is the one to use. CUB's scan moves each number once in and
// once out (decoupled look-back, Merrill and Garland 2016), which no scan in several passes can.
#include "common/wavefront/scan_library.h"

#include "common/device/device_array.h"

#if defined(__CUDACC__)
#include <cub/device/device_scan.cuh>
#else
#include <numeric>
#endif

namespace raylab {

#if defined(__CUDACC__)

std::int64_t scan_library_workspace(std::int64_t n) {
    std::size_t bytes = 0;
    const std::uint32_t* in = nullptr;
    std::uint32_t* out = nullptr;
    check(cub::DeviceScan::ExclusiveSum(nullptr, bytes, in, out, n), "ExclusiveSum, workspace");
    return static_cast<std::int64_t>(bytes / sizeof(std::uint32_t) + 1);
}

void scan_library(const std::uint32_t* in, std::uint32_t* out, std::int64_t n,
                  std::uint32_t* workspace) {
    std::size_t bytes = scan_library_workspace(n) * sizeof(std::uint32_t);
    check(cub::DeviceScan::ExclusiveSum(workspace, bytes, in, out, n), "ExclusiveSum");
}

#else

namespace {

// Device memory is the device's: the library is called by a kernel.
__global__ void library_kernel(const std::uint32_t* in, std::uint32_t* out, std::int64_t n) {
    std::exclusive_scan(in, in + n, out, std::uint32_t{0});
}

} // namespace

std::int64_t scan_library_workspace(std::int64_t) { return 0; }

void scan_library(const std::uint32_t* in, std::uint32_t* out, std::int64_t n, std::uint32_t*) {
    if (n == 0) return;
    library_kernel<<<1, 1>>>(in, out, n);
    check(cudaGetLastError(), "library_kernel");
}

#endif

} // namespace raylab
