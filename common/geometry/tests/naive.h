// The variants that the hard cases guard against, as they stand in many ray tracers.
#pragma once

#include "common/geometry/shapes.h"
#include "common/geometry/sheared_ray.h"

namespace raylab::naive {

// smallpt's sphere (Beason, 2007), in float, hits nearer than t_min dropped.
inline bool sphere(const Sphere& sphere, const Ray& ray, float t_min, float& t) {
    const Vec3 op = Vec3(sphere.center) - ray.o;
    const float b = dot(op, ray.d), r = float(sphere.radius);
    float det = b * b - dot(op, op) + r * r;
    if (det < 0) return false;
    det = sqrtf(det);
    t = b - det > t_min ? b - det : b + det;
    return t > t_min && t < ray.t_max;
}

// Moller and Trumbore, 1997, with a fixed epsilon on the determinant.
inline bool moller_trumbore(const Triangle& triangle, const Ray& ray, float epsilon, float t_min,
                            float& t) {
    const Vec3 e1 = triangle.v[1] - triangle.v[0], e2 = triangle.v[2] - triangle.v[0];
    const Vec3 p = cross(ray.d, e2);
    const float det = dot(e1, p);
    if (fabsf(det) < epsilon) return false;
    const Vec3 s = ray.o - triangle.v[0], q = cross(s, e1);
    const float u = dot(s, p) / det, v = dot(ray.d, q) / det;
    if (u < 0 || v < 0 || u + v > 1) return false;
    t = dot(e2, q) / det;
    if (t < t_min || t > ray.t_max) return false; // a NaN passes all of these
    return true;
}

// Woop's edges in float: watertight until the compiler fuses a multiply and a subtract.
inline bool woop(const Triangle& triangle, const Ray& ray) {
    const ShearedRay axes(ray);
    const float* o = &ray.o.x;
    const float* d = &ray.d.x;
    const float sx = d[axes.kx] / d[axes.kz], sy = d[axes.ky] / d[axes.kz];
    float x[3], y[3];
    for (int i = 0; i < 3; ++i) {
        const float* p = &triangle.v[i].x;
        const float z = p[axes.kz] - o[axes.kz];
        x[i] = p[axes.kx] - o[axes.kx] - sx * z;
        y[i] = p[axes.ky] - o[axes.ky] - sy * z;
    }
    const float u = x[2] * y[1] - y[2] * x[1], v = x[0] * y[2] - y[0] * x[2];
    const float w = x[1] * y[0] - y[1] * x[0];
    if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) return false;
    const Vec3 a = triangle.v[0], n = cross(triangle.v[1] - a, triangle.v[2] - a);
    return dot(n, a - ray.o) / dot(n, ray.d) > 0;
}

// A quad by its plane and four half spaces in float, hits nearer than t_min dropped.
inline bool quad(const Quad& quad, const Ray& ray, float t_min, float& t) {
    const float slope = dot(quad.normal, ray.d);
    if (fabsf(slope) < 1e-8f) return false;
    t = dot(quad.normal, quad.v[0] - ray.o) / slope;
    if (t < t_min || t >= ray.t_max) return false;
    for (int i = 0; i < 4; ++i) {
        const Vec3 a = quad.v[i], b = quad.v[(i + 1) % 4];
        if (dot(cross(b - a, ray(t) - a), quad.normal) < 0) return false;
    }
    return true;
}

inline bool plane(const Plane& plane, const Ray& ray, float& t) {
    t = dot(plane.normal, plane.point - ray.o) / dot(plane.normal, ray.d);
    return !(t < 0);
}

// Slabs by fminf and fmaxf, which drop a NaN: the CUDA samples' way.
inline bool slabs(const Bounds& box, const Ray& ray) {
    const Vec3 inv_d = 1.0f / ray.d;
    float t_near = 0, t_far = infinity;
    for (int axis = 0; axis < 3; ++axis) {
        const float a = (box.low[axis] - ray.o[axis]) * inv_d[axis];
        const float b = (box.high[axis] - ray.o[axis]) * inv_d[axis];
        t_near = fmaxf(t_near, fminf(a, b));
        t_far = fminf(t_far, fmaxf(a, b));
    }
    return t_near <= t_far;
}

} // namespace raylab::naive
