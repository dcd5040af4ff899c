// CUDA arrays; see api/array.h.
#include "common/simt/api/array.h"

#include "common/simt/api/pitched.h"
#include "common/simt/engine/machine.h"
#include "common/simt/engine/report.h"

#include <algorithm>
#include <new>

using namespace raylab::simt;

cudaError_t cudaMalloc3DArray(cudaArray_t* array, const cudaChannelFormatDesc* channels,
                              cudaExtent extent, unsigned flags, Where where) {
    auto made = new cudaArray{nullptr, *channels, extent, flags};
    size_t rows = std::max<size_t>(extent.height, 1) * std::max<size_t>(extent.depth, 1);
    void* memory = nullptr;
    cudaError_t error =
        made->row_bytes() == 0
            ? refuse(cudaErrorInvalidValue, place(where) + ": error: an array without elements")
            : allocate(&memory, made->row_bytes() * rows, MemoryKind::device, where);
    if (error) {
        delete made;
        return error;
    }
    made->data = static_cast<char*>(memory);
    *array = made;
    return cudaSuccess;
}

cudaError_t cudaMallocArray(cudaArray_t* array, const cudaChannelFormatDesc* channels, size_t width,
                            size_t height, unsigned flags, Where where) {
    return cudaMalloc3DArray(array, channels, {width, height, 0}, flags, where);
}

cudaError_t cudaFreeArray(cudaArray_t array, Where where) {
    if (!array) return sticky_error();
    cudaError_t error = release(array->data, MemoryKind::device, where);
    delete array;
    return error;
}

cudaError_t cudaArrayGetInfo(cudaChannelFormatDesc* channels, cudaExtent* extent, unsigned* flags,
                             cudaArray_t array) {
    if (channels) *channels = array->channels;
    if (extent) *extent = array->extent;
    if (flags) *flags = array->flags;
    return sticky_error();
}

cudaError_t cudaGetChannelDesc(cudaChannelFormatDesc* channels, cudaArray_const_t array) {
    *channels = array->channels;
    return sticky_error();
}

cudaError_t cudaMemcpy2DToArray(cudaArray_t to, size_t x, size_t y, const void* from, size_t pitch,
                                size_t width, size_t height, cudaMemcpyKind kind, Where where) {
    return cudaMemcpy2D(to->data + y * to->row_bytes() + x, to->row_bytes(), from, pitch, width,
                        height, kind, where);
}

cudaError_t cudaMemcpy2DFromArray(void* to, size_t pitch, cudaArray_const_t from, size_t x,
                                  size_t y, size_t width, size_t height, cudaMemcpyKind kind,
                                  Where where) {
    return cudaMemcpy2D(to, pitch, from->data + y * from->row_bytes() + x, from->row_bytes(), width,
                        height, kind, where);
}

cudaError_t cudaMemcpyToArray(cudaArray_t to, size_t x, size_t y, const void* from, size_t bytes,
                              cudaMemcpyKind kind, Where where) {
    return cudaMemcpy(to->data + y * to->row_bytes() + x, from, bytes, kind, where);
}

cudaError_t cudaMemcpyFromArray(void* to, cudaArray_const_t from, size_t x, size_t y, size_t bytes,
                                cudaMemcpyKind kind, Where where) {
    return cudaMemcpy(to, from->data + y * from->row_bytes() + x, bytes, kind, where);
}
