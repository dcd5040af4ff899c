// The surface at a hit: its position, its normals, and its material.
//
// A point computed as o + t d has an error of a few ulps of the ray's whole length. So the point is
// projected onto its shape in double and rounded once. Its error is then half an ulp of each
// coordinate, whatever the length of the ray was.
#pragma once

#include "common/geometry/edges.h"
#include "common/geometry/error.h"
#include "common/geometry/parameters.h"
#include "common/geometry/shading_normal.h"
#include "common/math/features.h"
#include "common/math/frame.h"
#include "common/scene/view.h"

namespace raylab {

struct SurfacePoint {
    Vec3 p;      // world position
    float error; // bound on how far rounding puts p, or an origin beside it, off the shape along ng
    Vec3 ng;     // unit geometric normal: outward on a sphere, else the shape's `normal`
    Frame shading; // z: unit shading normal n; n.ng > 0, and n.wo has the sign of ng.wo
    Vec2 uv;       // texture coordinates, v up; (0, 0) if the shape has none or F lacks them
    Vec3 colour = Vec3(1); // from the mesh's vertex colours: a factor on the reflectance
    int material;          // index into SceneView::materials
    int light;             // index into SceneView::lights, or -1
};

// p: the hit point o + t d, with an error of a few ulps of the ray's length. The result lies at the
// point of the shape that is nearest to p; near an edge it is moved inside (edges.h). wo: unit,
// towards the origin of the ray.
template <Features F>
HD_HOT SurfacePoint surface_on(const SceneView&, const Sphere& sphere, DVec3 p, Vec3) {
    const DVec3 n = glm::normalize(p - sphere.center);
    SurfacePoint s{};
    s.p = Vec3(sphere.center + sphere.radius * n);
    s.ng = Vec3(n);
    s.error = error_on_sphere(sphere, s.p, s.ng);
    s.shading = Frame::around(s.ng);
    if constexpr (F & feature::texture) s.uv = sphere_uv(s.ng);
    return s;
}

template <Features F>
HD_HOT SurfacePoint surface_on(const SceneView&, const Quad& quad, DVec3 p, Vec3) {
    const bool first_half = quad.parallelogram || is_in_first_half(quad, p);
    const ExactPlane plane = exact_plane(quad, first_half);
    const float conditioning = quad.conditioning[first_half ? 0 : 1];
    p = project(plane, p);
    SurfacePoint s{};
    s.p = Vec3(p);
    s.ng = quad.normal;
    s.error = error_on_plane(plane, s.p, s.ng, conditioning);
    if (!(quad.parallelogram && is_surely_clear_of_edges(quad, p, s.error))) {
        p = clear_of_edges(quad.v, plane, p, s.error);
        s.p = Vec3(p);
        s.error = error_on_plane(plane, s.p, s.ng, conditioning);
    }
    s.shading = Frame::around(s.ng);
    if constexpr (F & feature::texture) s.uv = quad_uv(quad, p);
    return s;
}

// A plane has no texture coordinates, because it has no edges between which u and v could run from
// 0 to 1.
template <Features F>
HD_HOT SurfacePoint surface_on(const SceneView&, const Plane& plane, DVec3 p, Vec3) {
    SurfacePoint s{};
    s.p = Vec3(project(exact_plane(plane), p));
    s.ng = plane.normal;
    s.error = error_on_plane(exact_plane(plane), s.p, s.ng, 1);
    s.shading = Frame::around(s.ng);
    return s;
}

template <Features F>
HD_HOT SurfacePoint surface_on(const SceneView& scene, const Triangle& triangle, DVec3 p, Vec3 wo) {
    const ExactPlane plane = exact_plane(triangle);
    const double conditioning = normal_conditioning(triangle.v[0], triangle.v[1], triangle.v[2]);
    p = project(plane, p);
    p = clear_of_edges(triangle.v, plane, p,
                       error_on_plane(plane, Vec3(p), triangle.normal, conditioning));
    SurfacePoint s{};
    s.p = Vec3(p);
    s.ng = triangle.normal;
    s.error = error_on_plane(plane, s.p, s.ng, conditioning);
    Vec3 normal = s.ng;
    if constexpr (F & feature::corners) {
        if (triangle.corners >= 0) {
            const TriangleCorners& at = scene.corners[triangle.corners];
            const Vec3 b = barycentrics(triangle, p);
            s.uv = b.x * at.uv[0] + b.y * at.uv[1] + b.z * at.uv[2];
            if constexpr (F & feature::vertex_colours) {
                if (at.colours >= 0) {
                    const CornerColours& c = scene.corner_colours[at.colours];
                    s.colour = b.x * c.factor[0] + b.y * c.factor[1] + b.z * c.factor[2];
                }
            }
            normal = facing_normal(interpolated_normal(at.normal, b, s.ng), s.ng, wo);
        }
    }
    s.shading = Frame::around(normal);
    return s;
}

template <Features F, class ShapeType>
HD SurfacePoint tagged_surface_on(const SceneView& scene, const ShapeType& shape, DVec3 p,
                                  Vec3 wo) {
    SurfacePoint s = surface_on<F>(scene, shape, p, wo);
    s.material = shape.tags.material;
    s.light = shape.tags.light;
    return s;
}

// The surface where the ray met hit.shape at hit.t; hit.found() must hold.
// F: the features of the scene. The kernel has no code for shapes that are not in F.
template <Features F>
HD_HOT SurfacePoint surface_at(const SceneView& scene, const Ray& ray, const Hit& hit) {
    const DVec3 p = DVec3(ray.o) + double(hit.t) * DVec3(ray.d);
    const Vec3 wo = -ray.d;
    if constexpr (F & feature::sphere) {
        if (hit.shape == Shape::sphere)
            return tagged_surface_on<F>(scene, scene.spheres[hit.index], p, wo);
    }
    if constexpr (F & feature::quad) {
        if (hit.shape == Shape::quad)
            return tagged_surface_on<F>(scene, scene.quads[hit.index], p, wo);
    }
    if constexpr (F & feature::plane) {
        if (hit.shape == Shape::plane)
            return tagged_surface_on<F>(scene, scene.planes[hit.index], p, wo);
    }
    if constexpr (F & feature::triangle) {
        if (hit.shape == Shape::triangle)
            return tagged_surface_on<F>(scene, scene.triangles[hit.index], p, wo);
    }
    return {};
}

} // namespace raylab
