// The power heuristic, in a form that neither overflows nor divides 0 by 0.
// Veach 1997, section 9.2; PBR4e 2.2.3.
#pragma once

#include "common/math/hd.h"

namespace raylab {

// Weight of a sample drawn with density f when the other technique has density g:
//     w = f^2 / (f^2 + g^2) = 1 / (1 + (g/f)^2).
// Squares of densities overflow for small lights; the ratio form has the right limits at 0 and
// infinity. f > 0, because the sample was drawn. If both are infinite, w = 1/2.
HD float power_heuristic(float f, float g) {
    if (f == g) return 0.5f;
    const float r = g / f;
    return 1 / (1 + r * r);
}

} // namespace raylab
