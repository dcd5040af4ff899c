// Rays that leave a surface neither find it again nor jump over what lies close to it.
#include "common/geometry/tests/naive.h"
#include "common/geometry/tests/support.h"

#include <algorithm>

namespace raylab::test {
namespace {

// Grazing or anywhere: half of the directions have cosines from 1e-4 up, evenly in the logarithm.
Vec3 leaving_direction(Random& random, Vec3 n) {
    if (random.below(2)) return random.cosine_direction(n);
    const double cosine = std::pow(10, random.between(-4, 0));
    const DVec3 side = glm::normalize(cross(DVec3(n), random.unit()));
    return Vec3(glm::normalize(cosine * DVec3(n) + sqrt(1 - cosine * cosine) * side));
}

std::string at_scale(const char* what, double s) {
    char text[80];
    std::snprintf(text, sizeof text, "%s, S = %g", what, s);
    return text;
}

// A world of one shape of size S, somewhere within S of the origin, and a ray that hits it.
struct OneShape {
    World world;
    Ray ray;

    OneShape(Random& random, int kind, double s) {
        const DVec3 at = s * random.unit();
        DVec3 target;
        if (kind == 0) {
            world.add(Sphere{Vec3(at), float(s * random.between(0.1, 1)), {}});
            target = DVec3(world.spheres[0].center) +
                     0.7 * double(world.spheres[0].radius) * random.unit();
        } else if (kind == 1) {
            const DVec3 a = at, b = at + s * random.unit(), c = at + s * random.unit();
            world.add(make_triangle(Vec3(a), Vec3(b), Vec3(c)));
            const double u = random.between(0, 0.5), v = random.between(0, 0.5);
            target = a + u * (b - a) + v * (c - a);
        } else if (kind == 2) {
            const DVec3 e1 = s * random.unit();
            const DVec3 e2 = s * glm::normalize(cross(e1, random.unit()));
            world.add(make_quad(Vec3(at), Vec3(at + e1), Vec3(at + e1 + e2), Vec3(at + e2)));
            target = at + random.uniform() * e1 + random.uniform() * e2;
        } else {
            world.add(Plane{Vec3(at), random.direction(), {}});
            target = at + s * random.uniform() *
                              glm::normalize(cross(DVec3(world.planes[0].normal), random.unit()));
        }
        world.make_runs(0);
        const Vec3 o(target + s * random.between(0.1, 10) * random.unit());
        ray = {o, Vec3(glm::normalize(target - DVec3(o)))};
    }
};

TEST(SELF_CONVEX, no_ray_finds_the_surface_it_leaves) {
    const int n = rays(10'000, 100'000);
    const char* names[] = {"sphere", "triangle", "quad", "plane"};
    for (double s : {1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6})
        for (int kind = 0; kind < 4; ++kind) {
            Random random(70 + kind);
            int left = 0, again = 0, naive_again = 0;
            for (int i = 0; i < n; ++i) {
                const OneShape one(random, kind, s);
                const SceneView scene = one.world.view();
                const Hit hit = intersect<all_shapes>(scene, one.ray);
                if (!hit.found()) continue;
                ++left;
                const SurfacePoint p = surface_at<all_shapes>(scene, one.ray, hit);
                // To either side; into a sphere the ray meets it again, on the far side.
                const bool outside = kind == 0 || random.below(2);
                const Vec3 w = leaving_direction(random, outside ? p.ng : -p.ng);
                again += intersect<all_shapes>(scene, spawn_ray(p, w)).found();
                const Ray naive_ray{one.ray(hit.t), w};
                const Hit naive_hit = intersect<all_shapes>(scene, naive_ray);
                naive_again += naive_hit.found() && naive_hit.t > 1e-4f;
            }
            ASSERT_GT(left, n / 3);
            const auto naive = s >= 1e4 ? std::optional(1e5 * naive_again / left) : std::nullopt;
            figure("SELF-CONVEX",
                   at_scale((std::string(names[kind]) + ", again per 1e5").c_str(), s),
                   1e5 * again / left, 0, naive);
        }
}

// From the inner of two concentric spheres, or of two parallel quads: the outer one stops every
// ray.
TEST(GAP_LEAK, a_blocker_close_above_the_surface_is_found) {
    const int n = rays(5'000, 100'000);
    for (double g : {1e-2, 1e-3, 1e-4, 1e-5})
        for (double s : {1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6}) {
            Random random(80);
            int left = 0, leaks = 0, naive_leaks = 0;
            for (int i = 0; i < n; ++i) {
                World world;
                const bool round = i % 2;
                if (round) {
                    world.add(Sphere{Vec3(0), float(s), {}});
                    world.add(Sphere{Vec3(0), float(s * (1 + g)), {}});
                } else {
                    const DVec3 normal = random.unit(),
                                e1 = s * glm::normalize(cross(normal, random.unit()));
                    const DVec3 e2 = cross(normal, e1), up = g * s * normal;
                    world.add(make_quad(Vec3(-0.1 * e1 - 0.1 * e2), Vec3(0.1 * e1 - 0.1 * e2),
                                        Vec3(0.1 * e1 + 0.1 * e2), Vec3(0.1 * e2 - 0.1 * e1)));
                    world.add(make_quad(Vec3(up - e1 - e2), Vec3(up + e1 - e2), Vec3(up + e1 + e2),
                                        Vec3(up - e1 + e2)));
                }
                const SceneView scene = world.view();
                const Vec3 towards = round ? random.direction() : -world.quads[0].normal;
                const Ray ray{Vec3(-2 * s * DVec3(towards)), towards};
                // The inner shape is hit by itself: the outer one is closed around it.
                World inner = world;
                if (round)
                    inner.spheres.pop_back();
                else
                    inner.quads.pop_back();
                const Hit hit = intersect<all_shapes>(inner.view(), ray);
                ASSERT_TRUE(hit.found());
                ++left;
                const SurfacePoint p = surface_at<all_shapes>(inner.view(), ray, hit);
                Vec3 w = random.cosine_direction(p.ng);
                if (dot(w, p.ng) < 0.1f) w = p.ng;
                const Hit stop = intersect<all_shapes>(scene, spawn_ray(p, w));
                leaks += !stop.found() || stop.index != 1 || stop.t > 1.01 * s;
                // t_min, and the point of the hit pushed out by a fixed distance
                Ray naive_ray{ray(hit.t) + 1e-4f * p.ng, w};
                const Hit naive_stop = intersect<all_shapes>(scene, naive_ray);
                naive_leaks +=
                    !naive_stop.found() || naive_stop.index != 1 || naive_stop.t > 1.01 * s;
            }
            const auto naive =
                g * s < 1e-4 ? std::optional(100.0 * naive_leaks / left) : std::nullopt;
            char what[32];
            std::snprintf(what, sizeof what, "leaks in %%, g = %g S", g);
            figure("GAP-LEAK", at_scale(what, s), 100.0 * leaks / left, g > 2e-5 ? 0 : 1, naive);
        }
}

// A unit scene moved by X: hits lie on their surface to an ulp of X, from however far the ray
// comes.
TEST(OFFSET, hit_points_lie_on_their_surface_wherever_the_scene_is) {
    const int n = rays(5'000, 100'000);
    for (double x : {1e2, 1e3, 1e4, 1e5, 1e6, 1e7}) {
        Random random(90);
        double worst = 0, naive_worst = 0;
        for (int i = 0; i < n; ++i) {
            const Vec3 center(x * random.unit());
            const Sphere sphere{center, 1, {}};
            const Plane plane{center, random.direction(), {}};
            World world;
            if (i % 2)
                world.add(sphere);
            else
                world.add(plane);
            const DVec3 away = 100.0 * x * random.unit();
            const Ray ray{Vec3(DVec3(center) + away), Vec3(glm::normalize(-away))};
            const Hit hit = intersect<all_shapes>(world.view(), ray);
            if (!hit.found()) continue;
            const auto residue = [&](Vec3 p) {
                const RVec f = RVec(p) - RVec(center);
                return double(i % 2 ? fabsl(sqrtl(dot(f, f)) - 1)
                                    : fabsl(dot(f, glm::normalize(RVec(plane.normal)))));
            };
            const SurfacePoint p = surface_at<all_shapes>(world.view(), ray, hit);
            worst = std::max(worst, residue(p.p));
            naive_worst = std::max(naive_worst, residue(ray(hit.t)));
        }
        const double ulp = std::ldexp(1.0, std::ilogb(x) - 23);
        char what[64];
        std::snprintf(what, sizeof what, "distance from the surface, scene at %g", x);
        figure("OFFSET", what, worst, ulp + 1e-6, naive_worst);
    }
}

// A point on an edge of the floor lies on the wall too. Kept clear of it, no ray starts behind it.
TEST(BOX_CORNER, nothing_escapes_from_a_closed_box) {
    const int n = rays(100'000, 1'000'000), bounces = 20;
    for (int kind = 0; kind < 3; ++kind) {
        Random random(100 + kind);
        int escapes = 0, naive_escapes = 0;
        for (int i = 0; i < n / bounces; ++i) {
            // A unit cube at the origin; a box of three sizes far from it; one turned at random.
            const DVec3 z = random.unit(), x = glm::normalize(cross(z, random.unit())),
                        y = cross(z, x);
            const DVec3 at = kind == 1 ? 300.0 * random.unit() : DVec3(0);
            const DVec3 size = kind == 1 ? DVec3(10, 55.5, 3.2) : DVec3(1);
            Vec3 corner[8];
            for (int k = 0; k < 8; ++k) {
                const DVec3 c = size * DVec3(k & 1, k >> 1 & 1, k >> 2);
                corner[k] = Vec3(at + (kind == 2 ? c.x * x + c.y * y + c.z * z : c));
            }
            World world;
            add_box(world, corner);
            const SceneView scene = world.view();
            // From an edge or a corner a millionth of the box inwards along each of its axes, but
            // at least 4 ulps of the coordinates: nearer, rounding may put it outside.
            const double least = 0x1p-21 * max_component(abs(corner[0]) + abs(corner[7]));
            const int k = random.below(8), along = random.below(4); // 3: at the corner
            DVec3 start(corner[k]);
            for (int axis = 0; axis < 3; ++axis) {
                const DVec3 side = DVec3(corner[k ^ (1 << axis)]) - DVec3(corner[k]);
                const double fraction = std::max(1e-6, least / glm::length(side));
                start += (axis == along ? random.between(fraction, 1 - fraction) : fraction) * side;
            }

            Ray ray{Vec3(start), random.direction()}, naive_ray = ray;
            for (int bounce = 0; bounce < bounces; ++bounce) {
                const Hit hit = intersect<feature::quad>(scene, ray);
                if (!hit.found()) {
                    ++escapes;
                    break;
                }
                const SurfacePoint p = surface_at<feature::quad>(scene, ray, hit);
                ray = spawn_ray(p, random.cosine_direction(-p.ng));
            }
            for (int bounce = 0; bounce < bounces; ++bounce) {
                float nearest = infinity, t;
                const Quad* found = nullptr;
                for (const Quad& quad : world.quads)
                    if (naive::quad(quad, naive_ray, 1e-4f, t) && t < nearest)
                        nearest = t, found = &quad;
                if (!found) {
                    ++naive_escapes;
                    break;
                }
                naive_ray = {naive_ray(nearest), random.cosine_direction(-found->normal)};
            }
        }
        const char* names[] = {"unit cube", "box at 300", "turned cube"};
        figure("BOX-CORNER", std::string("escapes, ") + names[kind], escapes, 0, naive_escapes);
    }
}

// The corners of a turned box do not lie in a plane to the last bit, and a ray along a face may see
// it as a bow tie. Wherever such a ray leaves, that is at the box, not somewhere along the ray.
TEST(BOX_CORNER, a_ray_along_a_face_ends_within_the_box) {
    int escapes = 0, beyond = 0, naive_bad = 0;
    Random random(140);
    for (int i = 0; i < rays(100'000, 1'000'000); ++i) {
        const DVec3 z = random.unit(), x = glm::normalize(cross(z, random.unit())), y = cross(z, x);
        Vec3 corner[8];
        for (int k = 0; k < 8; ++k)
            corner[k] = Vec3(double(k & 1) * x + double(k >> 1 & 1) * y + double(k >> 2) * z);
        World world;
        add_box(world, corner);
        // A few ulps above the floor, and along it to the same height.
        const auto above_floor = [&](double height) {
            return random.between(0.01, 0.99) * x + random.between(0.01, 0.99) * y + height * z;
        };
        const Vec3 o(above_floor(5e-7));
        const DVec3 to = above_floor(random.between(-1, 1) * 5e-7);
        const Ray ray{o, Vec3(glm::normalize(to - DVec3(o)))};
        const Hit hit = intersect<feature::quad>(world.view(), ray);
        escapes += !hit.found();
        const DVec3 p = DVec3(o) + double(hit.t) * DVec3(ray.d);
        const auto outside = [](double c) { return c < -1e-5 || c > 1 + 1e-5; };
        beyond += hit.found() && (outside(dot(p, x)) || outside(dot(p, y)) || outside(dot(p, z)));
        bool found = false;
        float t;
        for (const Quad& quad : world.quads) found = found || naive::quad(quad, ray, 1e-4f, t);
        naive_bad += !found;
    }
    figure("BOX-CORNER", "escapes along a face", escapes, 0, naive_bad);
    figure("BOX-CORNER", "hits along a face outside the box", beyond, 0);
}

// The direction of a shadow ray is rounded: at the far end of a long one by more than the light's
// own coordinates tell.
TEST(SELF_CONVEX, a_shadow_ray_from_far_away_is_free_of_a_light_near_the_origin) {
    int blocked = 0, naive_blocked = 0, shadow_rays = 0;
    Random random(150);
    for (int i = 0; i < rays(20'000, 200'000); ++i) {
        const DVec3 e1 = random.unit(), e2 = glm::normalize(cross(e1, random.unit()));
        World world;
        world.add(make_quad(Vec3(-e1 - e2), Vec3(e1 - e2), Vec3(e1 + e2), Vec3(e2 - e1)));
        const Quad& light = world.quads[0];
        const DVec3 n(light.normal);
        const double cosine = std::pow(10, random.between(-3, 0));
        const DVec3 away = 1e4 * glm::normalize(cosine * n + random.between(-1, 1) * e1 + e2);
        SurfacePoint p{};
        p.p = Vec3(away);
        p.ng = Vec3(glm::normalize(-away));
        p.error = rounding_error(p.p, p.ng);
        const Vec3 target(project(exact_plane(light, true), 1e-3 * (random.uniform() * e1 + e2)));
        ++shadow_rays;
        const float error = error_on_plane(exact_plane(light, true), target, light.normal, 1);
        const Vec3 facing = light.normal * copysignf(1, float(dot(away, n)));
        blocked += occluded<all_shapes>(world.view(), spawn_ray_to(p, target, error, facing));
        // Both ends moved off their surfaces, the way's own rounding forgotten.
        const Vec3 o = offset_point(p.p, p.ng, p.error, target - p.p);
        const Vec3 end = offset_point(target, light.normal, error, o - target);
        naive_blocked +=
            occluded<all_shapes>(world.view(), {o, normalize(end - o), length(end - o)});
    }
    figure("SELF-CONVEX", "long shadow rays blocked by their light in %",
           100.0 * blocked / shadow_rays, 0, 100.0 * naive_blocked / shadow_rays);
}

// A shadow ray is free of both its ends, and is stopped by what lies between them.
TEST(SELF_CONVEX, a_shadow_ray_sees_neither_of_its_ends) {
    const int n = rays(10'000, 100'000);
    for (double s : {1e-4, 1.0, 1e6}) {
        Random random(110);
        int blocked = 0, naive_blocked = 0, open = 0, shadow_rays = 0;
        for (int i = 0; i < n; ++i) {
            OneShape one(random, i % 4, s);
            const Hit hit = intersect<all_shapes>(one.world.view(), one.ray);
            if (!hit.found()) continue;
            const SurfacePoint p = surface_at<all_shapes>(one.world.view(), one.ray, hit);
            // A light: a quad or sphere on the outer side, at any distance.
            const DVec3 up(p.ng);
            const double distance = s * std::pow(10, random.between(-1, 2));
            const DVec3 there = DVec3(p.p) + distance * DVec3(leaving_direction(random, p.ng));
            const DVec3 e1 = 0.02 * distance * random.unit();
            const DVec3 e2 = 0.02 * distance * glm::normalize(cross(e1, random.unit()));
            Vec3 target, normal;
            float error;
            World world = one.world;
            if (i % 3) {
                const Quad light = make_quad(Vec3(there - e1 - e2), Vec3(there + e1 - e2),
                                             Vec3(there + e1 + e2), Vec3(there - e1 + e2));
                world.add(light);
                const DVec3 on = there + random.between(-1, 1) * e1 + random.between(-1, 1) * e2;
                target = Vec3(project(exact_plane(light, true), on));
                normal = light.normal;
                error = error_on_plane(exact_plane(light, true), target, normal, 1);
            } else {
                const Sphere light{Vec3(there), float(0.02 * distance), {}};
                world.add(light);
                const DVec3 out =
                    glm::normalize(DVec3(p.p) - there + 0.5 * distance * random.unit());
                target = Vec3(DVec3(light.center) + double(light.radius) * out);
                normal = Vec3(out);
                error = error_on_sphere(light, target, normal);
            }
            const DVec3 way = DVec3(target) - DVec3(p.p);
            // Only what really sees the other: clear of both tangent planes.
            if (dot(way, up) < 1e-5 * distance) continue;
            if (fabs(dot(way, DVec3(normal))) < 1e-4 * distance) continue;
            if (i % 3 == 0 && dot(way, DVec3(normal)) > 0) continue;
            ++shadow_rays;
            if (dot(way, DVec3(normal)) > 0) normal = -normal;
            const Ray shadow_ray = spawn_ray_to(p, target, error, normal);
            blocked += occluded<all_shapes>(world.view(), shadow_ray);
            const Ray naive_ray{p.p, normalize(target - p.p), length(target - p.p)};
            naive_blocked += occluded<all_shapes>(world.view(), naive_ray);
            // A small sphere in the middle of the way.
            world.add(Sphere{Vec3(0.5 * (DVec3(target) + DVec3(p.p))), float(1e-3 * distance), {}});
            open += !occluded<all_shapes>(world.view(), shadow_ray);
        }
        ASSERT_GT(shadow_rays, n / 10);
        figure("SELF-CONVEX", at_scale("shadow rays blocked by an end of theirs in %", s),
               100.0 * blocked / shadow_rays, 0, 100.0 * naive_blocked / shadow_rays);
        figure("SELF-CONVEX", at_scale("shadow rays past a blocker in %", s),
               100.0 * open / shadow_rays, 0);
    }
}

} // namespace
} // namespace raylab::test
