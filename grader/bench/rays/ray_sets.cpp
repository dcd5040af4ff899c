#include "grader/bench/rays/ray_sets.h"

#include "common/math/frame.h"
#include "common/sampling/hash.h"
#include "common/sampling/warp.h"

namespace raylab::bench {

namespace {

constexpr float before_hit = 0.999f;
constexpr float ao_reach = 0.2f; // of the diagonal

Vec2 random(std::uint32_t seed, RayKind kind, std::size_t i) {
    const Words w = pcg4d({seed, std::uint32_t(kind), std::uint32_t(i), 0});
    return Vec2(to_unit(w.x), to_unit(w.y));
}

std::vector<Ray> camera_rays(const Camera& camera, std::uint32_t seed) {
    std::vector<Ray> rays;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            rays.push_back(generate_ray(camera, x, y, random(seed, RayKind::primary, rays.size()),
                                        Vec2(0.5f)));
    return rays;
}

// Where rays leave from.
struct Start {
    Vec3 p;
    Vec3 n; // unit, on the side that the ray came from
};

std::vector<Start> starts(const RayMesh& mesh, const std::vector<Ray>& rays,
                          const RayStructure& tracer) {
    std::vector<RayAnswer> answers(rays.size());
    tracer.closest(rays, answers);
    std::vector<Start> result;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (answers[i].triangle < 0) continue;
        const Vec3 n = mesh.triangles[std::size_t(answers[i].triangle)].normal;
        result.push_back({rays[i](before_hit * answers[i].t), dot(n, rays[i].d) < 0 ? n : -n});
    }
    return result;
}

// The lamp is a hundredth of the height below the top, half as wide and deep as the bounds.
std::vector<Ray> shadow_rays(const std::vector<Start>& from, const Bounds& bounds,
                             std::uint32_t seed) {
    const Vec3 size = bounds.high - bounds.low;
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const Vec2 u = random(seed, RayKind::shadow, i);
        const Vec3 lamp = bounds.low + size * Vec3(0.25f + u.x / 2, 0.99f, 0.25f + u.y / 2);
        const Vec3 way = lamp - from[i].p;
        const float distance = length(way);
        if (distance > 0) rays.push_back({from[i].p, way / distance, before_hit * distance});
    }
    return rays;
}

std::vector<Ray> cosine_rays(const std::vector<Start>& from, RayKind kind, float reach,
                             std::uint32_t seed) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const Vec3 local = sample_cosine_hemisphere(random(seed, kind, i));
        rays.push_back({from[i].p, normalize(Frame::around(from[i].n).to_world(local)), reach});
    }
    return rays;
}

} // namespace

const char* name_of(RayKind kind) {
    constexpr const char* names[] = {"primary", "shadow", "ao", "diffuse1", "diffuse2"};
    return names[int(kind)];
}

std::vector<RaySet> make_ray_sets(const RayMesh& mesh, const RayStructure& tracer,
                                  std::uint32_t seed) {
    const Bounds bounds = bounds_of(mesh.triangles);
    const float reach = ao_reach * length(bounds.high - bounds.low);
    std::vector<Ray> primary = camera_rays(mesh.camera, seed);
    const std::vector<Start> first = starts(mesh, primary, tracer);
    std::vector<Ray> bounce = cosine_rays(first, RayKind::diffuse1, infinity, seed);
    const std::vector<Start> second = starts(mesh, bounce, tracer);
    std::vector<RaySet> sets;
    sets.push_back({RayKind::primary, std::move(primary)});
    sets.push_back({RayKind::shadow, shadow_rays(first, bounds, seed)});
    sets.push_back({RayKind::ao, cosine_rays(first, RayKind::ao, reach, seed)});
    sets.push_back({RayKind::diffuse1, std::move(bounce)});
    sets.push_back({RayKind::diffuse2, cosine_rays(second, RayKind::diffuse2, infinity, seed)});
    return sets;
}

} // namespace raylab::bench
