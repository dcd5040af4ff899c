// Smooth shading through which no light leaks and in which none is lost.
//
// A BSDF works around the shading normal n, the surface itself faces ng. Where a mesh's n is
// tilted, some of the directions above n lie below the face: light sent there would pass an opaque
// surface, and dropping it (Veach 1997, 5.3) makes a white furnace over a smooth head .925. Here
// they are folded back at the face, as if the face were a mirror to what its shading sends into it:
//   T(w) = w - 2 (w.ng) ng   where w lies on different sides of n and of ng,   T(w) = w elsewhere.
// T keeps solid angles, so light from wi is scattered by all directions that T takes there,
//   f'(wo, wi) = sum of f(wo, w) over T(w) = wi,   pdf'(wi) = sum of pdf(w),
// which are wi and its mirror image, one of them, or none. f' is the BSDF of the surface for all
// purposes: sampling, light sampling and their weights.
//
// Folded diffuse light would be twice as bright where it grazes the face, and a ball of few
// triangles would show a bright rim before its shadow: diffuse light is squeezed instead
// (squeeze.h).
//
// What both keep: nothing passes an opaque surface. The energy that leaves for each wo is the
// BSDF's own: integral of f' = integral of f. Delta lobes just fold. What it does not: f' is not
// reciprocal, which no interpolated normal is (Veach 1997, 5.3.2), and a tracer from the camera
// does not need. What it costs, in kernels with corners: a second f where the mirror image lies
// above n too.
#pragma once

#include "common/material/bsdf_sample.h"
#include "common/material/material.h"
#include "common/trace/surface.h"
#include "common/transport/squeeze.h"

namespace raylab {

// f' |cos| and pdf'. wo, wi: world. evaluate(wo, wi): the BSDF in the shading frame. F says whether
// n may be tilted at all.
template <Features F, class Evaluate>
HD_HOT BsdfValue fold_value(const SurfacePoint& surface, const Material& m, Vec3 wo, Vec3 wi,
                            const Evaluate& evaluate) {
    if constexpr ((F & feature::corners) != 0)
        if (m.kind == MaterialKind::diffuse) return squeeze_value(surface, wo, wi, evaluate);
    constexpr int images = F & feature::corners ? 2 : 1;
    const float side = dot(wi, surface.ng);
    BsdfValue sum;
    Vec3 w = wi;
    for (int i = 0; i < images; ++i, w = mirrored(surface, wi)) {
        const Vec3 local = surface.shading.to_local(w);
        if (!(side * local.z > 0)) continue; // T(w) is not wi
        const BsdfValue value = evaluate(surface.shading.to_local(wo), local);
        sum.f_cos += value.f_cos;
        sum.pdf += value.pdf;
    }
    return sum;
}

// A sample of the BSDF, drawn in the shading frame, becomes one of f': wi = T(w), world. Its weight
// stays: the mean of f / pdf over all w that fold to wi is f' / pdf'. Its density becomes pdf'.
template <Features F, class Evaluate>
HD_HOT BsdfSample fold_sample(const SurfacePoint& surface, const Material& m, Vec3 wo,
                              BsdfSample sample, const Evaluate& evaluate) {
    if (!sample.valid) return sample;
    if constexpr ((F & feature::corners) != 0)
        if (m.kind == MaterialKind::diffuse) return squeeze_sample(surface, wo, sample, evaluate);
    const Vec3 w = sample.wi;
    sample.wi = fold_to_world(surface, w);
    if constexpr ((F & feature::corners) != 0) {
        if (sample.specular) return sample;
        const Vec3 image = surface.shading.to_local(mirrored(surface, surface.shading.to_world(w)));
        if (w.z * image.z > 0) sample.pdf += evaluate(surface.shading.to_local(wo), image).pdf;
    }
    return sample;
}

} // namespace raylab
