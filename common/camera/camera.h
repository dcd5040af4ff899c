// The camera: a pinhole, or a thin lens when lens_radius > 0.
// PBR4e 5.2 (Projective Camera Models), 5.2.3 (The Thin Lens Model).
#pragma once

#include "common/geometry/ray.h"
#include "common/sampling/warp.h"

namespace raylab {

struct Camera {
    Vec3 position;
    Vec3 right, up, forward; // orthonormal; right = cross(forward, up)
    float half_width;        // tan of half the horizontal field of view
    float half_height;       // tan of half the vertical field of view
    float lens_radius;       // world units, 0: pinhole
    float focus_distance;    // world units, along forward, to the plane that is sharp
    int width, height;       // film, pixels
};

// A film of another size behind the same lens. The vertical field of view stays.
inline void set_film_size(Camera& camera, int width, int height) {
    camera.width = width;
    camera.height = height;
    camera.half_width = camera.half_height * static_cast<float>(width) / static_cast<float>(height);
}

//[ withhold 01
// The ray through pixel (x, y), (0, 0) at the top left. u_film: position within the pixel, in
// [0,1)^2 (jittered anti-aliasing, box filter). u_lens: position on the lens, in [0,1)^2.
HD_HOT Ray generate_ray(const Camera& camera, int x, int y, Vec2 u_film, Vec2 u_lens) {
    const float sx = (2 * (x + u_film.x) / camera.width - 1) * camera.half_width;
    const float sy = (1 - 2 * (y + u_film.y) / camera.height) * camera.half_height;
    if (camera.lens_radius == 0)
        return {camera.position, normalize(camera.forward + sx * camera.right + sy * camera.up)};

    // Every ray through the lens meets the same point of the plane in focus: from its place on the
    // lens the way there is (sx, sy, 1) focus_distance - (lens, 0) in the camera's frame. World
    // positions, two large numbers, stay out of the difference.
    const Vec2 lens = camera.lens_radius * sample_disk(u_lens);
    const Vec2 turn = lens / camera.focus_distance;
    const Vec3 o = camera.position + lens.x * camera.right + lens.y * camera.up;
    return {o,
            normalize(camera.forward + (sx - turn.x) * camera.right + (sy - turn.y) * camera.up)};
}
//]

} // namespace raylab
