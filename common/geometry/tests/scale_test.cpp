// POW2-SCALE: scaling a scene by a power of two scales lengths exactly and changes no other bit.
// It finds every absolute epsilon.
#include "common/geometry/tests/support.h"

#include <cstring>

namespace raylab::test {
namespace {

World room(float s) {
    World world;
    Random random(130);
    Vec3 corner[8];
    for (int k = 0; k < 8; ++k)
        corner[k] = s * Vec3(k & 1 ? 2.5f : -1.7f, k & 2 ? 1.3f : -0.9f, k & 4 ? 3.1f : -2.2f);
    add_box(world, corner);
    world.add(Plane{s * Vec3(0.1f, -0.6f, 0.3f), Vec3(0.6f, 0.8f, 0), {}});
    for (int i = 0; i < 4; ++i) world.add(Sphere{s * random.direction(), s * 0.3f, {}});
    for (int i = 0; i < 60; ++i) {
        const Vec3 at = random.direction();
        world.add(make_triangle(s * at, s * (at + 0.3f * random.direction()),
                                s * (at + 0.3f * random.direction())));
    }
    world.make_runs(16);
    return world;
}

// A fixed number of bounces in the room at scale s, as the bits of everything that has no unit of
// length and of everything that has one divided by s. step(ray, hit, surface) gives the next
// origin.
template <class Step> std::vector<std::uint32_t> walk(float s, int bounces, const Step& step) {
    const World world = room(s);
    const SceneView scene = world.view();
    Random random(131);
    Ray ray{s * Vec3(0.2f, 1.1f, 0.4f), random.direction()};
    std::vector<std::uint32_t> record;
    const auto put = [&](Vec3 v) {
        record.insert(record.end(), {bits(v.x), bits(v.y), bits(v.z)});
    };
    for (int i = 0; i < bounces; ++i) {
        const Hit hit = intersect<all_shapes>(scene, ray);
        if (!hit.found()) { // only where the walk's own epsilon lets it out
            record.push_back(~0u);
            ray = {s * Vec3(0.2f, 1.1f, 0.4f), random.direction()};
            continue;
        }
        const SurfacePoint p = surface_at<all_shapes>(scene, ray, hit);
        record.push_back(std::uint32_t(hit.id));
        record.push_back(bits(hit.t / s));
        put(p.p / s), put(p.ng), put(p.shading.x), put(p.shading.y);
        record.push_back(bits(p.error / s));
        const Ray shadow_ray = spawn_ray_to(p, s * Vec3(0.5f, 1, 0.5f), s * 1e-6f, Vec3(0, 1, 0));
        put(shadow_ray.o / s), put(shadow_ray.d);
        record.push_back(occluded<all_shapes>(scene, shadow_ray));
        const Vec3 n = dot(ray.d, p.ng) < 0 ? p.ng : -p.ng;
        ray = step(ray, hit, p, random.cosine_direction(n));
        put(ray.o / s);
    }
    return record;
}

double differing(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    size_t n = 0;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) n += a[i] != b[i];
    return double(n);
}

TEST(POW2_SCALE, no_bit_changes_but_the_exponent) {
    const int n = rays(2'000, 50'000);
    const auto ours = [](const Ray&, const Hit&, const SurfacePoint& p, Vec3 w) {
        return spawn_ray(p, w);
    };
    const auto naive = [](const Ray& ray, const Hit& hit, const SurfacePoint& p, Vec3 w) {
        return Ray{ray(hit.t) + 1e-4f * copysignf(1, dot(w, p.ng)) * p.ng, w};
    };
    const auto reference = walk(1, n, ours), naive_reference = walk(1, n, naive);
    for (int k : {-30, -20, -10, -3, -1, 1, 4, 9, 20, 30}) {
        const float s = std::ldexp(1.0f, k);
        figure("POW2-SCALE", "values that differ, scale 2^" + std::to_string(k),
               differing(walk(s, n, ours), reference), 0,
               differing(walk(s, n, naive), naive_reference));
    }
}

} // namespace
} // namespace raylab::test
