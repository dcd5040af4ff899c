// Stage 7: the unaccumulated colours join the film, once the last path of the batch has ended.
//
// All paths of the batch, not those that are alive: a path that ended early brings its light too.
// Each is added once, by the one thread that owns its pixel now.
#pragma once

#include "common/film/film.h"
#include "common/task/not_implemented.h"
#include "labs/03_wavefront/wave.h"

namespace raylab::lab03 {

// Counters are privatised, as in lab 02: blocks add to different copies.
constexpr int shards = 16;

// Per shard and bounce: the paths that ended there, by cause.
struct EndTally {
    unsigned long long ended[path_ends];
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
    // Steps:
    // 1. Add the slot's radiance, one sample, to the pixel that the pool names.
    //[ task 3.1
    add_sample(results.film[wave.pool.pixel[slot]], wave.pool.radiance[slot]);
    //| not_implemented("3.1", "accumulate_path()");
    //]
}

// For tests that compare paths.
HD void keep_record(const Wave& wave, int slot, const Results& results) {
    if (results.records != nullptr) results.records[wave.pool.pixel[slot]] = wave.pool.record[slot];
}

} // namespace raylab::lab03
