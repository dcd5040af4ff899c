#include "common/geometry/triangle.h"
#include "grader/bench/rays/ray_contestant.h"

namespace raylab::bench {

namespace {

class EveryTriangle : public RayStructure {
  public:
    EveryTriangle(std::span<const Triangle> triangles, int threads)
        : triangles_(triangles), threads_(threads) {}

    double closest(std::span<const Ray> rays, std::span<RayAnswer> answers) const override {
        return seconds_in_parts(rays.size(), threads_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) answers[i] = closest(rays[i]);
        });
    }
    double any(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override {
        return seconds_in_parts(rays.size(), threads_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) blocked[i] = is_blocked(rays[i]);
        });
    }

    std::optional<RayCounts> count_closest(std::span<const Ray> rays) const override {
        return RayCounts{0, double(rays.size()) * double(triangles_.size())};
    }

  private:
    // Tests the triangles in the order of their ids, so that of equal t the lowest id stays.
    RayAnswer closest(const Ray& ray) const {
        const ShearedRay sheared(ray);
        RayAnswer best;
        float t;
        for (const Triangle& triangle : triangles_)
            if (intersect(triangle, sheared, t) && t < best.t) best = {t, triangle.tags.id};
        return best;
    }
    bool is_blocked(const Ray& ray) const {
        const ShearedRay sheared(ray);
        float t;
        for (const Triangle& triangle : triangles_)
            if (intersect(triangle, sheared, t)) return true;
        return false;
    }

    std::span<const Triangle> triangles_;
    int threads_;
};

} // namespace

RayContestant brute_force() {
    constexpr double seconds_worth = 0x1p29; // of tests, on a core: two or so
    return {"brute", "every triangle, the test of labs 01 to 04", true, seconds_worth,
            [](std::span<const Triangle> triangles, int threads) {
                return BuiltStructure{std::make_unique<EveryTriangle>(triangles, threads),
                                      std::numeric_limits<double>::quiet_NaN(), 0};
            }};
}

} // namespace raylab::bench
