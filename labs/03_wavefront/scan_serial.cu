// Scan by one thread: the definition as a loop, and what parallel scans are measured by.
#include "common/device/device_array.h"
#include "labs/03_wavefront/scan.h"

namespace raylab::lab03 {

namespace {

__global__ void serial_kernel(const std::uint32_t* in, std::uint32_t* out, std::int64_t n) {
    std::uint32_t sum = 0;
    for (std::int64_t i = 0; i < n; ++i) {
        out[i] = sum;
        sum += in[i];
    }
}

} // namespace

void scan_serial(const std::uint32_t* in, std::uint32_t* out, std::int64_t n, std::uint32_t*) {
    if (n == 0) return;
    serial_kernel<<<1, 1>>>(in, out, n);
    check(cudaGetLastError(), "serial_kernel");
}

} // namespace raylab::lab03
