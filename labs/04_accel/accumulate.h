// Accumulation: the unaccumulated colours join the film, once the last path of the batch has ended.
//
// All paths of the batch, not those that are alive: a path that ended early brings its light too.
// Each is added once, by the one thread that owns its pixel now.
#pragma once

#include "common/film/film.h"
#include "labs/04_accel/wave.h"

namespace raylab::lab04 {

// Counters are privatised, as in lab 02: blocks add to different copies.
constexpr int shards = 16;

// Per shard and bounce: the paths that ended there, by cause.
struct EndTally {
    unsigned long long ended[path_ends];
};

// What walks visited. packs: of triangles; in the tree over spheres and quads, groups of these.
struct WalkTally {
    unsigned long long nodes, packs;
};

// What a batch leaves behind.
struct Results {
    FilmPixel* film;                 // a pixel each
    PathRecord* records;             // a pixel each; null unless somebody asked for them
    EndTally* tallies;               // shards * bounces
    unsigned long long* shadow_rays; // shards
    int bounces;
};

HD void accumulate_path(const Wave& wave, int slot, const Results& results) {
    add_sample(results.film[wave.pool.pixel[slot]], wave.pool.radiance[slot]);
}

// For tests that compare paths.
HD void keep_record(const Wave& wave, int slot, const Results& results) {
    if (results.records != nullptr) results.records[wave.pool.pixel[slot]] = wave.pool.record[slot];
}

} // namespace raylab::lab04
