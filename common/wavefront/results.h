// The arrays that stay when paths end, as kernels see them.
#pragma once

#include "common/film/film.h"
#include "common/film/ledger.h"

namespace raylab {

// Counters are privatised, as in lab 02: blocks add to different copies.
inline constexpr int shards = 16;

// Per shard and bounce: the paths that ended there, by cause.
struct EndTally {
    unsigned long long ended[path_ends];
};

// What the paths of a fill leave behind.
struct Results {
    FilmPixel* film;                 // a pixel each
    PathRecord* records;             // a pixel each; null unless somebody asked for them
    EndTally* tallies;               // shards * bounces
    unsigned long long* shadow_rays; // shards
    int bounces;
};

} // namespace raylab
