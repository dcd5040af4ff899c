// A fractal height field: octaves of value noise, each of half the size and half the height of the
// one before it (F. K. Musgrave, in Ebert et al., Texturing and Modeling, 2003, chapter 16). Over
// the unit square of x and z, heights in [0, 0.5); 2 n^2 triangles that face up.
#include "common/load/procedural/parts.h"
#include "common/load/procedural/procedural.h"
#include "common/sampling/hash.h"

#include <cmath>

namespace raylab {
namespace {

// In [0, 1): random at the points of a lattice, between them a smooth step each way.
double noise(double x, double z, std::uint32_t octave, std::uint32_t seed) {
    const double i = std::floor(x), j = std::floor(z);
    const auto at = [&](int di, int dj) {
        return pcg4d({seed, octave, std::uint32_t(i) + di, std::uint32_t(j) + dj}).x * 0x1p-32;
    };
    const auto step = [](double t) { return t * t * (3 - 2 * t); };
    const double u = step(x - i), v = step(z - j);
    const double near = at(0, 0) + u * (at(1, 0) - at(0, 0));
    const double far = at(0, 1) + u * (at(1, 1) - at(0, 1));
    return near + v * (far - near);
}

} // namespace

Mesh make_terrain(int triangles, std::uint32_t seed) {
    int n = 1; // cells along a side
    while (2LL * (n + 1) * (n + 1) <= triangles) ++n;
    const auto height = [&](double x, double z) {
        double sum = 0;
        std::uint32_t octave = 1;
        for (double cells = 2; cells <= 2 * n; cells *= 2, ++octave)
            sum += noise(x * cells, z * cells, octave, seed) / (2 * cells);
        return sum;
    };
    Mesh mesh;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = double(i) / n, z = double(j) / n;
            add_position(mesh, DVec3(x, height(x, z), z));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
            add_triangle(mesh, a, c, b);
            add_triangle(mesh, b, c, d);
        }
    return mesh;
}

} // namespace raylab
