#include "grader/bench/rays/ray_contestant.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <string>

namespace raylab::bench {

namespace {

struct Released {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Released>;
using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Released>;

RTCRay as_embree(const Ray& ray) {
    RTCRay r{};
    r.org_x = ray.o.x, r.org_y = ray.o.y, r.org_z = ray.o.z;
    r.dir_x = ray.d.x, r.dir_y = ray.d.y, r.dir_z = ray.d.z;
    r.tfar = ray.t_max;
    r.mask = ~0u;
    return r;
}

class EmbreeTree : public RayStructure {
  public:
    EmbreeTree(std::span<const Triangle> triangles, int threads, bool robust) : threads_(threads) {
        device_.reset(rtcNewDevice(("threads=" + std::to_string(threads)).c_str()));
        if (!device_) throw ContestantError("Embree could not start: rtcNewDevice failed");
        rtcSetDeviceMemoryMonitorFunction(
            device_.get(),
            [](void* bytes, ssize_t change, bool) {
                *static_cast<std::atomic<ssize_t>*>(bytes) += change;
                return true;
            },
            &bytes_);
        scene_.reset(rtcNewScene(device_.get()));
        rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_MEDIUM);
        if (robust) rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
        add(triangles);
        const ssize_t given = bytes_;
        const auto start = std::chrono::steady_clock::now();
        rtcCommitScene(scene_.get());
        seconds = seconds_since(start);
        bytes = double(bytes_ - given);
        if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE)
            throw ContestantError("Embree could not build its tree: is there enough memory?");
    }

    double seconds = 0, bytes = 0;

    double closest(std::span<const Ray> rays, std::span<RayAnswer> answers) const override {
        return seconds_in_parts(rays.size(), threads_, [&](std::size_t begin, std::size_t end) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            for (std::size_t i = begin; i < end; ++i) {
                RTCRayHit asked{as_embree(rays[i]), {}};
                asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
                rtcIntersect1(scene_.get(), &context, &asked);
                answers[i] = asked.hit.geomID == RTC_INVALID_GEOMETRY_ID
                                 ? RayAnswer{}
                                 : RayAnswer{asked.ray.tfar, int(asked.hit.primID)};
            }
        });
    }
    double any(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override {
        return seconds_in_parts(rays.size(), threads_, [&](std::size_t begin, std::size_t end) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            for (std::size_t i = begin; i < end; ++i) {
                RTCRay ray = as_embree(rays[i]);
                rtcOccluded1(scene_.get(), &context, &ray);
                blocked[i] = ray.tfar < 0; // Embree's way of saying so
            }
        });
    }

  private:
    void add(std::span<const Triangle> triangles) {
        RTCGeometry mesh = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<Vec3*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0,
                                                                    RTC_FORMAT_FLOAT3, sizeof(Vec3),
                                                                    3 * triangles.size()));
        auto* indices = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(unsigned), triangles.size()));
        if (!vertices || !indices) throw ContestantError("Embree could not hold the triangles");
        for (const Triangle& t : triangles) vertices = std::copy(t.v, t.v + 3, vertices);
        for (unsigned i = 0; i < 3 * triangles.size(); ++i) indices[i] = i;
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(scene_.get(), mesh);
        rtcReleaseGeometry(mesh);
    }

    int threads_;
    std::atomic<ssize_t> bytes_ = 0; // outlives the device, which counts in it
    Device device_;
    EmbreeScene scene_;
};

} // namespace

RayContestant embree(bool robust) {
    return {robust ? "embree_robust" : "embree",
            std::string("Embree " RTC_VERSION_STRING ", one ray at a time, medium quality") +
                (robust ? ", robust" : ""),
            false, std::numeric_limits<double>::infinity(),
            [robust](std::span<const Triangle> triangles, int threads) {
                auto tree = std::make_unique<EmbreeTree>(triangles, threads, robust);
                const double seconds = tree->seconds, bytes = tree->bytes;
                return BuiltStructure{std::move(tree), seconds, bytes};
            }};
}

} // namespace raylab::bench
