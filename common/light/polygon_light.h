// Quad and triangle lights, sampled uniformly by area. PBR4e 12.4 (area lights).
//
// The rest of the renderer calls only two functions of a light: its sample and its pdf. To sample
// by solid angle, only these two functions would have to change.
#pragma once

#include "common/geometry/shapes.h"
#include "common/light/light_sample.h"
#include "common/sampling/warp.h"

namespace raylab {

HD Vec3 lerp(Vec3 a, Vec3 b, float t) { return (1 - t) * a + t * b; }

// Points of a convex quad are p(s, t), bilinear in the corners: p(0,0) = v[0], p(1,0) = v[1],
// p(1,1) = v[2], p(0,1) = v[3]. The area that ds dt covers at p(s, t) is bilinear too, because the
// quad is planar. At a corner it is the area of the parallelogram that the two edges at this corner
// span.
struct QuadMeasure {
    float at00, at10, at01, at11;
};

// The area of the parallelogram over e1 and e2, from its unit normal: |e1 x e2| = (e1 x e2).normal.
// The length itself would need squares, which underflow in small scenes.
HD float parallelogram_area(Vec3 e1, Vec3 e2, Vec3 normal) { return dot(cross(e1, e2), normal); }

HD QuadMeasure measure(const Quad& quad) {
    const Vec3 bottom = quad.v[1] - quad.v[0], right = quad.v[2] - quad.v[1];
    const Vec3 top = quad.v[2] - quad.v[3], left = quad.v[3] - quad.v[0];
    return {parallelogram_area(bottom, left, quad.normal),
            parallelogram_area(bottom, right, quad.normal),
            parallelogram_area(top, left, quad.normal),
            parallelogram_area(top, right, quad.normal)};
}

// Chooses (s, t) with density proportional to that area, so p(s, t) is uniform over the quad: first
// t, from the density averaged over s, then s for that t.
HD_HOT Vec2 sample_quad(const Quad& quad, Vec2 u) {
    if (quad.parallelogram) return u; // the measure is constant
    const QuadMeasure m = measure(quad);
    const float t = sample_linear(u.y, m.at00 + m.at10, m.at01 + m.at11);
    return Vec2(sample_linear(u.x, (1 - t) * m.at00 + t * m.at01, (1 - t) * m.at10 + t * m.at11),
                t);
}

HD_HOT LightSample sample_quad_light(const Quad& quad, Vec3 radiance, Vec3 from, Vec2 u) {
    const Vec2 st = sample_quad(quad, u);
    const Vec3 p = lerp(lerp(quad.v[0], quad.v[1], st.x), lerp(quad.v[3], quad.v[2], st.x), st.y);
    const Vec3 largest = glm::max(glm::max(abs(quad.v[0]), abs(quad.v[1])),
                                  glm::max(abs(quad.v[2]), abs(quad.v[3])));
    const float error = gamma_bound(8) * dot(largest, abs(quad.normal));
    return light_sample_at(from, p, error, quad.normal, 1 / quad.area, radiance);
}

HD float quad_light_pdf(const Quad& quad, Vec3 from, Vec3 wi, Vec3 p) {
    return solid_angle_pdf(1 / quad.area, length_squared(p - from), fabsf(dot(wi, quad.normal)));
}

HD float triangle_area(const Triangle& triangle) {
    return parallelogram_area(triangle.v[1] - triangle.v[0], triangle.v[2] - triangle.v[0],
                              triangle.normal) /
           2;
}

HD LightSample sample_triangle_light(const Triangle& triangle, Vec3 radiance, Vec3 from, Vec2 u) {
    const Vec2 b = sample_triangle(u);
    const Vec3 p = b.x * triangle.v[0] + b.y * triangle.v[1] + (1 - b.x - b.y) * triangle.v[2];
    const Vec3 largest =
        glm::max(glm::max(abs(triangle.v[0]), abs(triangle.v[1])), abs(triangle.v[2]));
    const float error = gamma_bound(8) * dot(largest, abs(triangle.normal));
    return light_sample_at(from, p, error, triangle.normal, 1 / triangle_area(triangle), radiance);
}

HD float triangle_light_pdf(const Triangle& triangle, Vec3 from, Vec3 wi, Vec3 p) {
    return solid_angle_pdf(1 / triangle_area(triangle), length_squared(p - from),
                           fabsf(dot(wi, triangle.normal)));
}

} // namespace raylab
