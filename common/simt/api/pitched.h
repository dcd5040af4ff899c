// Memory in rows: pitched allocations, and copies of rectangles and boxes.
#pragma once

#include "common/simt/api/array.h"

struct cudaPitchedPtr {
    void* ptr;
    size_t pitch, xsize, ysize; // bytes from row to row, width and height of the allocation
};
struct cudaPos {
    size_t x, y, z;
};
inline cudaPitchedPtr make_cudaPitchedPtr(void* pointer, size_t pitch, size_t width,
                                          size_t height) {
    return {pointer, pitch, width, height};
}
inline cudaPos make_cudaPos(size_t x, size_t y, size_t z) { return {x, y, z}; }

// An extent's width is in bytes, unless an array takes part in a copy; a position's x likewise.
struct cudaMemcpy3DParms {
    cudaArray_t srcArray;
    cudaPos srcPos;
    cudaPitchedPtr srcPtr;
    cudaArray_t dstArray;
    cudaPos dstPos;
    cudaPitchedPtr dstPtr;
    cudaExtent extent;
    cudaMemcpyKind kind;
};

namespace raylab::simt {
cudaError_t allocate_pitched(void** pointer, size_t* pitch, size_t width, size_t rows,
                             const Where& where);
} // namespace raylab::simt

// Rows start at multiples of 512 bytes, as on most GPUs.
template <class T>
inline cudaError_t cudaMallocPitch(T** pointer, size_t* pitch, size_t width, size_t height,
                                   raylab::simt::Where where = raylab::simt::Where::here()) {
    void* memory = nullptr;
    auto error = raylab::simt::allocate_pitched(&memory, pitch, width, height, where);
    *pointer = static_cast<T*>(memory);
    return error;
}
cudaError_t cudaMalloc3D(cudaPitchedPtr* pointer, cudaExtent extent,
                         raylab::simt::Where where = raylab::simt::Where::here());

cudaError_t cudaMemcpy2D(void* to, size_t to_pitch, const void* from, size_t from_pitch,
                         size_t width, size_t height, cudaMemcpyKind kind,
                         raylab::simt::Where where = raylab::simt::Where::here());
cudaError_t cudaMemcpy3D(const cudaMemcpy3DParms* copy,
                         raylab::simt::Where where = raylab::simt::Where::here());
cudaError_t cudaMemset2D(void* to, size_t pitch, int byte, size_t width, size_t height,
                         raylab::simt::Where where = raylab::simt::Where::here());
cudaError_t cudaMemset3D(cudaPitchedPtr to, int byte, cudaExtent extent,
                         raylab::simt::Where where = raylab::simt::Where::here());

inline cudaError_t cudaMemcpy2DAsync(void* to, size_t to_pitch, const void* from, size_t from_pitch,
                                     size_t width, size_t height, cudaMemcpyKind kind,
                                     cudaStream_t stream = nullptr,
                                     raylab::simt::Where where = raylab::simt::Where::here()) {
    const raylab::simt::InStream in(stream);
    return cudaMemcpy2D(to, to_pitch, from, from_pitch, width, height, kind, where);
}
inline cudaError_t cudaMemcpy3DAsync(const cudaMemcpy3DParms* copy, cudaStream_t stream = nullptr,
                                     raylab::simt::Where where = raylab::simt::Where::here()) {
    const raylab::simt::InStream in(stream);
    return cudaMemcpy3D(copy, where);
}
inline cudaError_t cudaMemset2DAsync(void* to, size_t pitch, int byte, size_t width, size_t height,
                                     cudaStream_t stream = nullptr,
                                     raylab::simt::Where where = raylab::simt::Where::here()) {
    const raylab::simt::InStream in(stream);
    return cudaMemset2D(to, pitch, byte, width, height, where);
}
inline cudaError_t cudaMemcpyPeer(void* to, int, const void* from, int, size_t bytes,
                                  raylab::simt::Where where = raylab::simt::Where::here()) {
    return cudaMemcpy(to, from, bytes, cudaMemcpyDeviceToDevice, where);
}
inline cudaError_t cudaMemcpyPeerAsync(void* to, int to_device, const void* from, int from_device,
                                       size_t bytes, cudaStream_t stream = nullptr,
                                       raylab::simt::Where where = raylab::simt::Where::here()) {
    const raylab::simt::InStream in(stream);
    return cudaMemcpyPeer(to, to_device, from, from_device, bytes, where);
}
template <class T>
inline cudaError_t
cudaMemcpyToSymbolAsync(T& symbol, const void* from, size_t bytes, size_t offset,
                        cudaMemcpyKind kind, cudaStream_t stream = nullptr,
                        raylab::simt::Where where = raylab::simt::Where::here()) {
    const raylab::simt::InStream in(stream);
    return cudaMemcpyToSymbol(symbol, from, bytes, offset, kind, where);
}
template <class T>
inline cudaError_t
cudaMemcpyFromSymbolAsync(void* to, const T& symbol, size_t bytes, size_t offset,
                          cudaMemcpyKind kind, cudaStream_t stream = nullptr,
                          raylab::simt::Where where = raylab::simt::Where::here()) {
    const raylab::simt::InStream in(stream);
    return cudaMemcpyFromSymbol(to, symbol, bytes, offset, kind, where);
}
