// The two recursive tracers, and the data that all their calls share.
#pragma once

#include "common/film/ledger.h"
#include "common/sampling/sampler.h"
#include "common/scene/settings.h"
#include "common/scene/view.h"
#include "common/task/not_implemented.h"

namespace raylab::lab01 {

// One sample of one pixel. What changes from surface to surface is in the calls' arguments.
struct Path {
    const SceneView& scene;
    const RenderSettings& settings;
    Sampler sampler;
    PathRecord& record; // what became of it, for the ledger
};

// Radiance that comes back along `ray`. bounce: surfaces touched before. bsdf_pdf: density of the
// ray's direction, delta_pdf for a camera ray. throughput: product of all weights so far.
Vec3 trace_path(const Path& path, const Ray& ray, int bounce, float bsdf_pdf, Vec3 throughput);

// The same by Whitted's rules. depth: surfaces touched before.
Vec3 trace_whitted(const Path& path, const Ray& ray, int depth, std::uint32_t node);

} // namespace raylab::lab01
