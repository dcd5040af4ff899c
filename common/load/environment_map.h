// How an environment map is sampled: in proportion to what each texel sends, and every texel that
// sends anything with at least 1/16 of what even sampling would give its row, and it in its row.
#pragma once

#include "common/load/picture.h"

#include <vector>

namespace raylab {

// The tables of Environment (view.h): row_cdf[i] = P(row < i), height + 1 values;
// column_cdf[row * (width + 1) + j] = P(column < j | row). They begin with 0, end with 1 and never
// fall. All are multiples of 2^-24, as random numbers are: probabilities are exact. A black texel
// is never chosen, but a black row is uniform within, a black map is uniform over the sphere.
struct EnvironmentCdf {
    std::vector<float> row, column;
};

EnvironmentCdf environment_cdf(const Picture& map);

// Turns a map about +y by any finite angle in degrees, counterclockwise seen from above: +z goes to
// +x, and so towards smaller u. Columns move as far as whole ones do; returns what is left, in
// turns to be added to u, at most half a column. An angle of k columns is exact, and leaves 0.
float rotate_map(Picture& map, double degrees);

} // namespace raylab
