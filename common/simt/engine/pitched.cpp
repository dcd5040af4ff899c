// Copies of rectangles and boxes; see api/pitched.h. Each row is a copy of its own, and is checked
// as such.
#include "common/simt/api/pitched.h"

#include "common/simt/engine/machine.h"
#include "common/simt/engine/report.h"

#include <algorithm>

using namespace raylab::simt;

namespace {

// One end of a copy: where its first byte is, and the way to the next row and the next layer.
struct Box {
    char* first;
    size_t row, layer;
    char* at(size_t y, size_t z) const { return first + z * layer + y * row; }
};

Box box(cudaArray_t array, const cudaPitchedPtr& pointer, const cudaPos& at, size_t x_bytes) {
    Box box{static_cast<char*>(pointer.ptr), pointer.pitch,
            pointer.pitch * std::max<size_t>(pointer.ysize, 1)};
    if (array) {
        size_t row = array->row_bytes();
        box = {array->data, row, row * std::max<size_t>(array->extent.height, 1)};
    }
    box.first = box.at(at.y, at.z) + at.x * x_bytes;
    return box;
}

cudaError_t bad_pitch(const Where& where, size_t pitch, size_t width) {
    return refuse(cudaErrorInvalidPitchValue,
                  place(where) + ": error: a pitch of " + std::to_string(pitch) +
                      " bytes is less than the width of " + std::to_string(width) + " bytes");
}

} // namespace

namespace raylab::simt {

cudaError_t allocate_pitched(void** pointer, size_t* pitch, size_t width, size_t rows,
                             const Where& where) {
    *pitch = (width + 511) / 512 * 512;
    return allocate(pointer, *pitch * rows, MemoryKind::device, where);
}

} // namespace raylab::simt

cudaError_t cudaMalloc3D(cudaPitchedPtr* pointer, cudaExtent extent, Where where) {
    void* memory = nullptr;
    size_t pitch = 0;
    cudaError_t error =
        allocate_pitched(&memory, &pitch, extent.width, extent.height * extent.depth, where);
    *pointer = {memory, pitch, extent.width, extent.height};
    return error;
}

cudaError_t cudaMemcpy2D(void* to, size_t to_pitch, const void* from, size_t from_pitch,
                         size_t width, size_t height, cudaMemcpyKind kind, Where where) {
    if (width > std::min(to_pitch, from_pitch))
        return bad_pitch(where, std::min(to_pitch, from_pitch), width);
    for (size_t y = 0; y < height; ++y)
        if (cudaError_t error =
                cudaMemcpy(static_cast<char*>(to) + y * to_pitch,
                           static_cast<const char*>(from) + y * from_pitch, width, kind, where))
            return error;
    return sticky_error();
}

cudaError_t cudaMemcpy3D(const cudaMemcpy3DParms* copy, Where where) {
    cudaArray_t array = copy->srcArray ? copy->srcArray : copy->dstArray;
    size_t unit = array ? array->element_bytes() : 1;
    Box from = box(copy->srcArray, copy->srcPtr, copy->srcPos, unit);
    Box to = box(copy->dstArray, copy->dstPtr, copy->dstPos, unit);
    size_t width = copy->extent.width * unit;
    if (width > std::min(from.row, to.row))
        return bad_pitch(where, std::min(from.row, to.row), width);
    for (size_t z = 0; z < copy->extent.depth; ++z)
        for (size_t y = 0; y < copy->extent.height; ++y)
            if (cudaError_t error =
                    cudaMemcpy(to.at(y, z), from.at(y, z), width, copy->kind, where))
                return error;
    return sticky_error();
}

cudaError_t cudaMemset2D(void* to, size_t pitch, int byte, size_t width, size_t height,
                         Where where) {
    if (width > pitch) return bad_pitch(where, pitch, width);
    for (size_t y = 0; y < height; ++y)
        if (cudaError_t error = cudaMemset(static_cast<char*>(to) + y * pitch, byte, width, where))
            return error;
    return sticky_error();
}

cudaError_t cudaMemset3D(cudaPitchedPtr to, int byte, cudaExtent extent, Where where) {
    for (size_t z = 0; z < extent.depth; ++z)
        if (cudaError_t error = cudaMemset2D(static_cast<char*>(to.ptr) + z * to.pitch * to.ysize,
                                             to.pitch, byte, extent.width, extent.height, where))
            return error;
    return sticky_error();
}
