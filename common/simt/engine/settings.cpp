// Settings of a GPU that change nothing here, but are remembered (api/device.h); peers; choices.
#include "common/simt/api/device.h"
#include "common/simt/engine/machine.h"

#include <array>
#include <cstdio>

using namespace raylab::simt;

namespace {

struct Settings {
    std::array<size_t, 7> limits{1 << 10, 1 << 20, 8 << 20, 2, 2048, 64, 0};
    cudaFuncCache cache = cudaFuncCachePreferNone;
    cudaSharedMemConfig banks = cudaSharedMemBankSizeFourByte;
    unsigned flags = cudaDeviceMapHost;
};
Settings settings;

cudaError_t no_limit(const char* call, int limit) {
    return refuse(cudaErrorInvalidValue,
                  std::string("error: ") + call + ": there is no limit " + std::to_string(limit));
}

cudaError_t no_peer(const char* call) {
    return refuse(cudaErrorPeerAccessUnsupported,
                  std::string("error: ") + call + ": the CPU machine is one device, without peers");
}

} // namespace

cudaError_t cudaDeviceGetLimit(size_t* value, cudaLimit limit) {
    if (size_t(limit) >= settings.limits.size()) return no_limit("cudaDeviceGetLimit()", limit);
    *value = settings.limits[limit];
    return sticky_error();
}

cudaError_t cudaDeviceSetLimit(cudaLimit limit, size_t value) {
    if (size_t(limit) >= settings.limits.size()) return no_limit("cudaDeviceSetLimit()", limit);
    settings.limits[limit] = value;
    return sticky_error();
}

cudaError_t cudaDeviceSetCacheConfig(cudaFuncCache config) {
    settings.cache = config;
    return sticky_error();
}

cudaError_t cudaDeviceGetCacheConfig(cudaFuncCache* config) {
    *config = settings.cache;
    return sticky_error();
}

cudaError_t cudaDeviceSetSharedMemConfig(cudaSharedMemConfig config) {
    settings.banks = config;
    return sticky_error();
}

cudaError_t cudaDeviceGetSharedMemConfig(cudaSharedMemConfig* config) {
    *config = settings.banks;
    return sticky_error();
}

cudaError_t cudaSetDeviceFlags(unsigned flags) {
    settings.flags = flags;
    return sticky_error();
}

cudaError_t cudaGetDeviceFlags(unsigned* flags) {
    *flags = settings.flags;
    return sticky_error();
}

cudaError_t cudaChooseDevice(int* device, const cudaDeviceProp*) { return cudaGetDevice(device); }

cudaError_t cudaDeviceGetPCIBusId(char* text, int length, int device) {
    if (device != 0) return cudaSetDevice(device);
    std::snprintf(text, size_t(length), "0000:00:00.0");
    return sticky_error();
}

cudaError_t cudaDeviceGetStreamPriorityRange(int* least, int* greatest) {
    if (least) *least = 0;
    if (greatest) *greatest = -5;
    return sticky_error();
}

cudaError_t cudaDeviceCanAccessPeer(int* can, int device, int peer) {
    if (device != 0 || peer != 0) return cudaSetDevice(device ? device : peer);
    *can = 0;
    return sticky_error();
}

cudaError_t cudaDeviceEnablePeerAccess(int, unsigned) {
    return no_peer("cudaDeviceEnablePeerAccess()");
}

cudaError_t cudaDeviceDisablePeerAccess(int) { return no_peer("cudaDeviceDisablePeerAccess()"); }
