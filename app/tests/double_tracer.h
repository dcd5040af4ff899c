// A second opinion: a path tracer of quads and triangles, all diffuse and grey, lit by one quad.
//
// Written in double and apart from the renderer on purpose: its own intersection (Moller and
// Trumbore), frames, sampling (a lamp point, then a cosine direction by trigonometry) and random
// numbers. It shares with the renderer nothing but the scene's corners.
#pragma once

#include "common/scene/scene.h"

#include <cmath>
#include <random>

namespace raylab::app {

struct DoubleTracer {
    struct Face {
        DVec3 a, e1, e2; // a triangle
        bool glows;
    };
    std::vector<Face> faces;
    DVec3 lamp, lamp_u, lamp_v; // corner and sides of a rectangle
    DVec3 position, right, up, forward;
    double half_width, half_height;
    int width, height, max_depth;
    double albedo, radiance;

    DoubleTracer(const Scene& scene, double a, double l)
        : position(scene.camera.position), right(scene.camera.right), up(scene.camera.up),
          forward(scene.camera.forward), half_width(scene.camera.half_width),
          half_height(scene.camera.half_height), width(scene.camera.width),
          height(scene.camera.height), max_depth(scene.render.max_depth), albedo(a), radiance(l) {
        for (const Quad& q : scene.quads) {
            const bool glows = q.tags.light >= 0;
            add(q.v[0], q.v[1], q.v[2], glows);
            add(q.v[0], q.v[2], q.v[3], glows);
            if (glows) lamp = q.v[0], lamp_u = DVec3(q.v[1]) - lamp, lamp_v = DVec3(q.v[3]) - lamp;
        }
        for (const Triangle& t : scene.triangles) add(t.v[0], t.v[1], t.v[2], false);
    }

    void add(DVec3 a, DVec3 b, DVec3 c, bool glows) { faces.push_back({a, b - a, c - a, glows}); }

    // The nearest face within (1e-9, far), or null.
    const Face* hit(DVec3 o, DVec3 d, double far, double& t) const {
        const Face* nearest = nullptr;
        for (const Face& f : faces) {
            const DVec3 p = glm::cross(d, f.e2), s = o - f.a, q = glm::cross(s, f.e1);
            const double det = dot(f.e1, p), u = dot(s, p) / det, v = dot(d, q) / det;
            const double distance = dot(f.e2, q) / det;
            if (u < 0 || v < 0 || u + v > 1 || !(distance > 1e-9) || distance >= far) continue;
            nearest = &f, t = far = distance;
        }
        return nearest;
    }

    // One sample of a pixel. The lamp counts where the camera sees it, then by its own points
    // alone.
    double sample(int x, int y, std::mt19937_64& random) const {
        std::uniform_real_distribution<double> u(0, 1);
        const double sx = (2 * (x + u(random)) / width - 1) * half_width;
        const double sy = (1 - 2 * (y + u(random)) / height) * half_height;
        DVec3 o = position, d = glm::normalize(forward + sx * right + sy * up);
        double sum = 0, weight = 1, t = 0;
        for (int depth = 1;; ++depth) {
            const Face* face = hit(o, d, 1e30, t);
            if (!face) return sum;
            if (depth == 1 && face->glows) sum += radiance;
            if (depth == max_depth) return sum;
            const DVec3 p = o + t * d;
            DVec3 n = glm::normalize(glm::cross(face->e1, face->e2));
            if (dot(n, d) > 0) n = -n;

            const double u1 = u(random), u2 = u(random);
            const DVec3 to_lamp = lamp + u1 * lamp_u + u2 * lamp_v - p;
            const double distance = glm::length(to_lamp);
            const DVec3 w = to_lamp / distance, lamp_normal = glm::cross(lamp_u, lamp_v);
            double blocked;
            if (dot(w, n) > 0 && !hit(p, w, distance * (1 - 1e-9), blocked))
                sum += weight * albedo / M_PI * radiance * dot(w, n) *
                       std::fabs(dot(w, lamp_normal)) / (distance * distance);

            const double phi = 2 * M_PI * u(random), r2 = u(random);
            const DVec3 side = std::fabs(n.x) > 0.5 ? DVec3(0, 1, 0) : DVec3(1, 0, 0);
            const DVec3 bx = glm::normalize(glm::cross(side, n)), by = glm::cross(n, bx);
            d = std::sqrt(r2) * (std::cos(phi) * bx + std::sin(phi) * by) + std::sqrt(1 - r2) * n;
            o = p;
            weight *= albedo;
        }
    }
};

} // namespace raylab::app
