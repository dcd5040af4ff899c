// float3, int2, uint4 and the other small vectors of CUDA, with its alignments, and their make_*.
#pragma once

namespace raylab::simt {

using schar = signed char;
using uchar = unsigned char;
using ushort = unsigned short;
using uint = unsigned int;
using ulong = unsigned long;
using longlong = long long;
using ulonglong = unsigned long long;

} // namespace raylab::simt

// Vectors of 2 and 4 are loaded in one piece and aligned for it, at most to 16 bytes.
#define RAYLAB_VECTOR_TYPES(T, name)                                                               \
    struct name##1 {                                                                               \
        T x;                                                                                       \
    };                                                                                             \
    struct alignas(sizeof(T) * 2) name##2 {                                                        \
        T x, y;                                                                                    \
    };                                                                                             \
    struct name##3 {                                                                               \
        T x, y, z;                                                                                 \
    };                                                                                             \
    struct alignas(sizeof(T) >= 4 ? 16 : sizeof(T) * 4) name##4 {                                  \
        T x, y, z, w;                                                                              \
    };                                                                                             \
    constexpr name##1 make_##name##1(T x) { return {x}; }                                          \
    constexpr name##2 make_##name##2(T x, T y) { return {x, y}; }                                  \
    constexpr name##3 make_##name##3(T x, T y, T z) { return {x, y, z}; }                          \
    constexpr name##4 make_##name##4(T x, T y, T z, T w) { return {x, y, z, w}; }

RAYLAB_VECTOR_TYPES(raylab::simt::schar, char)
RAYLAB_VECTOR_TYPES(raylab::simt::uchar, uchar)
RAYLAB_VECTOR_TYPES(short, short)
RAYLAB_VECTOR_TYPES(raylab::simt::ushort, ushort)
RAYLAB_VECTOR_TYPES(int, int)
RAYLAB_VECTOR_TYPES(raylab::simt::uint, uint)
RAYLAB_VECTOR_TYPES(long, long)
RAYLAB_VECTOR_TYPES(raylab::simt::ulong, ulong)
RAYLAB_VECTOR_TYPES(raylab::simt::longlong, longlong)
RAYLAB_VECTOR_TYPES(raylab::simt::ulonglong, ulonglong)
RAYLAB_VECTOR_TYPES(float, float)
RAYLAB_VECTOR_TYPES(double, double)

#undef RAYLAB_VECTOR_TYPES
