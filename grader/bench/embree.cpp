#include "common/geometry/intersect.h"
#include "common/math/frame.h"
#include "common/sampling/hash.h"
#include "common/sampling/warp.h"
#include "grader/bench/traversal.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

namespace raylab::bench {

namespace {

constexpr int largest_film = 128;
constexpr double tolerated_share = 1e-4; // of rays that may differ: grazing an edge
constexpr float tolerated_t = 1e-4f;

// Embree's scene, released with the object.
class EmbreeScene {
  public:
    EmbreeScene(const Scene& scene)
        : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
        std::vector<Vec3> corners;
        for (const Quad& q : scene.quads)
            for (const int i : {0, 1, 2, 0, 2, 3}) corners.push_back(q.v[i]);
        for (const Triangle& t : scene.triangles) corners.insert(corners.end(), t.v, t.v + 3);
        triangles_ = static_cast<int>(corners.size() / 3);

        RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<Vec3*>(rtcSetNewGeometryBuffer(
            mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3), corners.size()));
        auto* indices = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(unsigned), corners.size() / 3));
        std::copy(corners.begin(), corners.end(), vertices);
        for (unsigned i = 0; i < corners.size(); ++i) indices[i] = i;
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(scene_, mesh);
        rtcReleaseGeometry(mesh);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST); // no gaps at edges, as we have none
        rtcCommitScene(scene_);
    }
    ~EmbreeScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    int triangles() const { return triangles_; }

    // The distance to the closest hit, or infinity.
    float operator()(const Ray& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit asked{};
        asked.ray.org_x = ray.o.x, asked.ray.org_y = ray.o.y, asked.ray.org_z = ray.o.z;
        asked.ray.dir_x = ray.d.x, asked.ray.dir_y = ray.d.y, asked.ray.dir_z = ray.d.z;
        asked.ray.tfar = infinity;
        asked.ray.mask = ~0u;
        asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &asked);
        return asked.hit.geomID == RTC_INVALID_GEOMETRY_ID ? infinity : asked.ray.tfar;
    }

  private:
    RTCDevice device_;
    RTCScene scene_;
    int triangles_ = 0;
};

constexpr Features polygons = feature::quad | feature::triangle;

struct Timing {
    double mrays = 0;
    std::vector<float> t;
};

template <class Closest> Timing trace(const std::vector<Ray>& rays, const Closest& closest) {
    Timing result;
    result.t.resize(rays.size());
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < rays.size(); ++i) result.t[i] = closest(rays[i]);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    result.mrays = 1e-6 * double(rays.size()) / taken.count();
    return result;
}

// Not through the middle of the pixels: in a symmetric scene those meet edges exactly, and on which
// side of an edge a ray passes is then a matter of rules, which differ.
std::vector<Ray> camera_rays(Camera camera) {
    const int larger = std::max(camera.width, camera.height);
    if (larger > largest_film)
        set_film_size(camera, std::max(1, camera.width * largest_film / larger),
                      std::max(1, camera.height * largest_film / larger));
    camera.lens_radius = 0;
    std::vector<Ray> rays;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            rays.push_back(generate_ray(camera, x, y, Vec2(0.4371f, 0.5913f), Vec2(0.5f)));
    return rays;
}

// They start a thousandth of the way short of the hit, so that no offset decides what is found.
std::vector<Ray> bounce_rays(const SceneView& view, const std::vector<Ray>& rays) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<Ray> bounces;
    for (const Ray& ray : rays) {
        const Hit hit = intersect<polygons>(view, ray);
        if (!hit.found()) continue;
        const Vec3 n = hit.shape == Shape::quad ? view.quads[hit.index].normal
                                                : view.triangles[hit.index].normal;
        const Frame frame = Frame::around(dot(n, ray.d) < 0 ? n : -n);
        const Vec2 u(uniform(random), uniform(random));
        bounces.push_back({ray(0.999f * hit.t), frame.to_world(sample_cosine_hemisphere(u))});
    }
    return bounces;
}

bool differ(float a, float b) {
    return std::isinf(a) != std::isinf(b) ||
           (std::isfinite(a) && std::fabs(a - b) > tolerated_t * std::max(a, b));
}

TraversalRow race(const char* name, const std::vector<Ray>& rays, const SceneView& view,
                  const EmbreeScene& embree, int rounds) {
    TraversalRow row;
    row.rays = name;
    row.count = static_cast<int>(rays.size());
    std::vector<double> ours, theirs, ratios;
    for (int round = 0; round < rounds; ++round) {
        const Timing a =
            trace(rays, [&](const Ray& ray) { return intersect<polygons>(view, ray).t; });
        const Timing b = trace(rays, embree);
        ours.push_back(a.mrays);
        theirs.push_back(b.mrays);
        ratios.push_back(a.mrays / b.mrays);
        row.differing = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) row.differing += differ(a.t[i], b.t[i]);
    }
    row.raylab_mrays = measured(ours);
    row.embree_mrays = measured(theirs);
    if (row.differing <= tolerated_share * double(rays.size())) row.ratio = measured(ratios);
    return row;
}

} // namespace

std::string embree_version() { return "Embree " RTC_VERSION_STRING; }

TraversalResult bench_traversal(const Scene& scene, int rounds) {
    TraversalResult result;
    result.scene = scene.name;
    if (scene.quads.empty() && scene.triangles.empty())
        throw ContestantError(fmt::format("{} has no polygons, and Embree is asked about nothing "
                                          "else",
                                          scene.name));
    const auto leave_out = [&](std::size_t n, const char* what) {
        if (n > 0)
            result.left_out += fmt::format("{}{} {}", result.left_out.empty() ? "" : ", ", n, what);
    };
    leave_out(scene.spheres.size(), "spheres");
    leave_out(scene.planes.size(), "planes");
    const EmbreeScene embree(scene);
    result.triangles = embree.triangles();
    const SceneView whole = view(scene);
    const std::vector<Ray> camera = camera_rays(scene.camera);
    result.rows.push_back(race("camera", camera, whole, embree, rounds));
    const std::vector<Ray> bounces = bounce_rays(whole, camera);
    if (!bounces.empty()) result.rows.push_back(race("bounce", bounces, whole, embree, rounds));
    return result;
}

} // namespace raylab::bench
