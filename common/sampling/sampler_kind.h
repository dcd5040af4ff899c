// Where random numbers come from, by name.
#pragma once

namespace raylab {

// sobol: Owen-scrambled Sobol points, spread evenly over a pixel's samples. independent: a hash of
// (seed, pixel, sample, dimension).
enum class SamplerKind : int { sobol, independent };

} // namespace raylab
