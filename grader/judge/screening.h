// One stage of tier 2: every region's luminance (Welch's t) and chroma (Hotelling's T^2) against
// the reference, at a false-alarm rate that holds for all of them together (Bonferroni: p < alpha /
// K).
#pragma once

#include "grader/judge/moments.h"

namespace raylab {

struct ScreeningOptions {
    // Regions whose replicates have a larger excess kurtosis are merged into the next larger one.
    double kurtosis_limit = 3;
    // Where few paths carry the light, all replicates may have missed most of it and agree on too
    // little. So a region's variance is not taken below what the reference predicts for it, times
    // the replicates' share of the predicted variance over all regions (at most 1).
    bool variance_floor = true;
    // Relative differences below this are rounding.
    double rounding = 1e-5;
};

struct RegionTest {
    Region region;
    bool chroma = false;          // else luminance
    TestResult test;              // the sign of a luminance t: above 0 the image is too bright
    DVec3 direction{0};           // colour direction of the difference that was found
    DVec3 image{0}, reference{0}; // mean R, G, B
    double standard_error = 0;    // of the luminance difference
    double reference_share = 0;   // of its variance, from the reference
};

struct Screening {
    std::vector<RegionTest> tests;
    int planned = 0;  // K: tests before merging, never fewer than were done
    int merged = 0;   // regions merged into larger ones
    RegionTest worst; // smallest p
    RegionTest whole; // luminance of the whole image
};

// Needs at least 4 replicates.
Screening screen(const Replicates& replicates, const ReferenceTiles& reference, int reference_spp,
                 const ScreeningOptions& options = {});

// One region's t along one direction: the second stage asks only about the first's finding.
TestResult retest(const Replicates& replicates, const ReferenceTiles& reference, int reference_spp,
                  const Region& region, const DVec3& direction,
                  const ScreeningOptions& options = {});

} // namespace raylab
