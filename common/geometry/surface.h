// The surface at a hit: where it is, which way it faces, what it is made of.
//
// A point computed as o + t d is wrong by a few ulps of the whole way. It is put back on its shape in
// double and rounded once, so its error is half an ulp a coordinate, however far the ray came.
#pragma once

#include "common/geometry/quad.h"
#include "common/geometry/sphere.h"
#include "common/math/frame.h"
#include "common/scene/features.h"
#include "common/scene/view.h"

namespace raylab {

struct SurfacePoint {
    Vec3 p;        // world position
    float error;   // how far along ng rounding can put p, and an origin beside it, off the shape
    Vec3 ng;       // unit geometric normal, outward (of a sphere), else as the shape defines it
    Frame shading; // z: unit shading normal, on the same side as ng
    Vec2 uv;       // texture coordinates, v up; (0, 0) where the shape has none
    int material;  // index into SceneView::materials
    int light;     // index into SceneView::lights, or -1
};

// Half an ulp along n from rounding p, and as much again from rounding an origin beside it.
HD float rounding_error(Vec3 p, Vec3 n) { return gamma_bound(2) * dot(abs(p), abs(n)); }

// The error of a point on a plane; besides its own rounding that of the plane's equation in double,
// where `conditioning` >= 1 is how much the computation of the normal magnifies it.
HD float error_on_plane(const ExactPlane& plane, Vec3 p, Vec3 n, double conditioning) {
    const DVec3 lever = glm::abs(DVec3(p) - plane.point);
    return rounding_error(p, n) + float(0x1p-50 * conditioning * (lever.x + lever.y + lever.z));
}

// The sphere's own test computes |f|^2 - r^2 in float: 6 roundings of r^2, that is 3 u of r.
HD float error_on_sphere(const Sphere& sphere, Vec3 p, Vec3 n) {
    return rounding_error(p, n) + gamma_bound(4) * sphere.radius;
}

// |e1| |e2| / |e1 x e2|: 1 for a right angle at the first corner, large for a needle.
HD double conditioning_of(Vec3 a, Vec3 b, Vec3 c) {
    const DVec3 e1 = DVec3(b) - DVec3(a), e2 = DVec3(c) - DVec3(a), n = cross(e1, e2);
    return sqrt(dot(e1, e1) * (dot(e2, e2) / dot(n, n)));
}

// Longitude over 2 pi from the x axis towards z, and latitude from the south pole (-y) over pi.
HD Vec2 sphere_uv(Vec3 n) {
    const float u = atan2f(n.z, n.x) * inv_two_pi;
    return Vec2(u < 0 ? u + 1 : u, acosf(clamp(-n.y, -1.0f, 1.0f)) * inv_pi);
}

// Coordinates along the sides v[0] v[1] and v[0] v[3]; (0, 0) to (1, 1) over a parallelogram.
HD Vec2 quad_uv(const Quad& quad, DVec3 p) {
    const DVec3 o(quad.v[0]), e1 = DVec3(quad.v[1]) - o, e2 = DVec3(quad.v[3]) - o;
    const DVec3 n = cross(e1, e2);
    return Vec2(dot(cross(p - o, e2), n), dot(cross(e1, p - o), n)) / float(dot(n, n));
}

// Barycentric coordinates of p: the weights of the corners 0, 1, 2.
HD Vec3 barycentrics(const Triangle& triangle, DVec3 p) {
    const DVec3 o(triangle.v[0]), e1 = DVec3(triangle.v[1]) - o, e2 = DVec3(triangle.v[2]) - o;
    const DVec3 n = cross(e1, e2);
    const double b1 = dot(cross(p - o, e2), n) / dot(n, n);
    const double b2 = dot(cross(e1, p - o), n) / dot(n, n);
    return Vec3(1 - b1 - b2, b1, b2);
}

// The surface where the ray met hit.shape at hit.t. F must hold the features of the scene.
template <Features F>
HD SurfacePoint surface_at(const SceneView& scene, const Ray& ray, const Hit& hit) {
    const DVec3 near_p = DVec3(ray.o) + double(hit.t) * DVec3(ray.d);
    SurfacePoint s{};
    ShapeTags tags{};
    Vec3 normal; // shading

    if constexpr (F & feature::sphere) {
        if (hit.shape == Shape::sphere) {
            const Sphere& sphere = scene.spheres[hit.index];
            const DVec3 out = near_p - DVec3(sphere.center);
            const DVec3 n = out / sqrt(dot(out, out));
            s.p = Vec3(DVec3(sphere.center) + double(sphere.radius) * n);
            normal = s.ng = Vec3(n);
            s.error = error_on_sphere(sphere, s.p, s.ng);
            if constexpr (F & feature::texture) s.uv = sphere_uv(s.ng);
            tags = sphere.tags;
        }
    }
    if constexpr (F & feature::quad) {
        if (hit.shape == Shape::quad) {
            const Quad& quad = scene.quads[hit.index];
            const ExactPlane plane = exact_plane(quad);
            const DVec3 p = project(plane, near_p);
            s.p = Vec3(p);
            normal = s.ng = quad.normal;
            s.error = error_on_plane(plane, s.p, s.ng,
                                     conditioning_of(quad.v[0], quad.v[1], quad.v[3]));
            if constexpr (F & feature::texture) s.uv = quad_uv(quad, p);
            tags = quad.tags;
        }
    }
    if constexpr (F & feature::plane) {
        if (hit.shape == Shape::plane) {
            const Plane& plane = scene.planes[hit.index];
            s.p = Vec3(project(exact_plane(plane), near_p));
            normal = s.ng = plane.normal;
            s.error = error_on_plane(exact_plane(plane), s.p, s.ng, 1);
            tags = plane.tags;
        }
    }
    if constexpr (F & feature::triangle) {
        if (hit.shape == Shape::triangle) {
            const Triangle& triangle = scene.triangles[hit.index];
            const ExactPlane plane = exact_plane(triangle);
            const DVec3 p = project(plane, near_p);
            s.p = Vec3(p);
            normal = s.ng = triangle.normal;
            s.error = error_on_plane(plane, s.p, s.ng,
                                     conditioning_of(triangle.v[0], triangle.v[1], triangle.v[2]));
            if constexpr (F & feature::corners) {
                if (triangle.corners >= 0) {
                    const TriangleCorners& at = scene.corners[triangle.corners];
                    const Vec3 b = barycentrics(triangle, p);
                    s.uv = b.x * at.uv[0] + b.y * at.uv[1] + b.z * at.uv[2];
                    const Vec3 n = b.x * at.normal[0] + b.y * at.normal[1] + b.z * at.normal[2];
                    if (length_squared(n) > 0) normal = normalize(n);
                    if (dot(normal, s.ng) < 0) normal = -normal;
                }
            }
            tags = triangle.tags;
        }
    }
    s.shading = Frame::around(normal);
    s.material = tags.material;
    s.light = tags.light;
    return s;
}

} // namespace raylab
