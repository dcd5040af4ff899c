// The ledger: what a render did, bounce by bounce. Viewer, bench, grader and tests read this one
// account; nobody counts twice.
#pragma once

#include "common/math/hd.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

// Why a path ended.
enum class PathEnd : int {
    escaped,  // left the scene
    absorbed, // the surface scatters nothing further
    roulette, // Russian roulette
    depth,    // touched max_depth surfaces
};
constexpr int path_ends = 4;

// One path of one sample, as its thread leaves it: 12 bytes a pixel.
struct PathRecord {
    std::uint16_t length = 0;      // rays traced: one for each surface touched, one for an escape
    std::uint16_t shadow_rays = 0; // shadow rays sent, at most 65535
    PathEnd end = PathEnd::depth;
    std::uint32_t hits = 0; // fingerprint of the ids of the surfaces touched, in their order
};

// Every lab calls this once a ray: two labs trace the same path exactly if their records agree.
// id: of the shape, -1 for an escape.
HD void record_hit(PathRecord& record, int id) {
    record.length += record.length < 65535;
    record.hits = (record.hits ^ static_cast<std::uint32_t>(id + 2)) * 0x9e3779b1u;
}

// And this once a shadow ray.
HD void record_shadow_ray(PathRecord& record) { record.shadow_rays += record.shadow_rays < 65535; }

// What rays visited of a structure.
struct WalkSums {
    std::uint64_t rays = 0;  // that walked
    std::uint64_t nodes = 0; // what is read at once: a pair of boxes, eight boxes, a plane
    std::uint64_t packs = 0; // tested: of up to eight triangles; or groups of spheres or quads
};

// The structure over the triangles, of labs that have one and scenes with triangles.
struct StructureFacts {
    std::string name, walk; // "wide", "trail"
    std::string why;        // this one
    int triangles = 0;      // of the scene
    int nodes = 0, triangle_packs = 0, depth = 0;
    std::uint64_t bytes = 0;  // of nodes and packs
    double build_seconds = 0; // on the host's clock, without the copy to the device
    WalkSums shadow_rays;     // their walks; those of other rays are counted by bounce
};

// The tree over spheres and quads, of labs that have one and scenes with many of them.
struct ShapeTreeFacts {
    int spheres = 0, quads = 0; // of the scene
    int nodes = 0, depth = 0;
    std::uint64_t bytes = 0; // of nodes
    double build_seconds = 0;
    WalkSums rays, shadow_rays;
};

struct BounceCounts {
    std::uint64_t rays = 0;              // paths alive when the bounce began
    std::uint64_t ended[path_ends] = {}; // of those, how many ended here, by cause
    std::uint64_t lanes = 0; // lanes that a GPU holds for them: 32 for each warp with a path alive
    // Of the launches that traced this bounce alone, if the lab has such: their blocks, and the
    // batches in which the device works them off.
    std::uint64_t blocks = 0, batches = 0;
    WalkSums walks; // of these rays, in labs with a structure over the triangles
};

// One of the kernels that a lab launches over and over.
struct StageCounts {
    std::string name;
    std::uint64_t launches = 0, blocks = 0, threads = 0;
    double seconds = 0; // on the device
};

struct Ledger {
    std::string lab, scene, scene_hash, features, machine;
    int width = 0, height = 0, samples = 0; // samples: per pixel
    std::vector<BounceCounts> bounces;
    std::uint64_t shadow_rays = 0;
    std::uint64_t rejected = 0;         // samples that were not finite
    std::uint64_t threads_launched = 0; // over all launches
    double seconds = 0;                 // tracing alone
    std::vector<StageCounts> stages;    // of labs that trace in several launches a sample
    int pool_paths = 0, path_bytes = 0; // paths in flight at most, device memory for each
    std::optional<StructureFacts> structure;
    std::optional<ShapeTreeFacts> shapes;

    std::uint64_t rays() const; // camera and scattered rays + shadow rays
};

// The share of lanes at work in bounce b, the complement of the lecture's wasted cycles. 1 if b has
// no lanes.
double lanes_alive(const BounceCounts& bounce);

std::string to_json(const Ledger& ledger);

// A table for people: one row a bounce.
std::string to_table(const Ledger& ledger);

} // namespace raylab
