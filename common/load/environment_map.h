// How an environment map is sampled: in proportion to the light that each texel sends. But a row
// that sends light is chosen at least 1/16 as often as by even sampling, and so is such a texel in
// its row.
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
// +x, and so towards smaller u. Moves the texels by whole columns, and returns the rest of the
// angle, at most half a column, in turns to be added to u. An angle of k columns is exact, and
// leaves 0.
float rotate_map(Picture& map, double degrees);

} // namespace raylab
