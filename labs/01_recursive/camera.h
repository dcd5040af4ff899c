// Camera rays: the ray from the eye through a point of a pixel.
#pragma once

#include "common/camera/camera.h"
#include "common/task/not_implemented.h"

namespace raylab::lab01 {

// The ray through pixel (x, y), (0, 0) at the top left; u_film in [0,1)^2 is the place within the
// pixel, u_lens in [0,1)^2 the place on the lens.
inline Ray camera_ray(const Camera& camera, int x, int y, Vec2 u_film, Vec2 u_lens) {
    //[ task 1.1
    // Pixels to the image plane at distance 1: x to the right, y upwards, so rows are turned over.
    const float sx = (2 * (x + u_film.x) / camera.width - 1) * camera.half_width;
    const float sy = (1 - 2 * (y + u_film.y) / camera.height) * camera.half_height;
    if (camera.lens_radius == 0)
        return {camera.position, normalize(camera.forward + sx * camera.right + sy * camera.up)};

    // A thin lens: all rays of a film point meet in one point of the plane in focus.
    // The way there, in the camera's frame, is (sx, sy, 1) focus_distance - (lens, 0). In world
    // space it would be a difference of positions, and far from the origin all digits would cancel.
    const Vec2 lens = camera.lens_radius * sample_disk(u_lens);
    const Vec2 turn = lens / camera.focus_distance;
    const Vec3 o = camera.position + lens.x * camera.right + lens.y * camera.up;
    return {o,
            normalize(camera.forward + (sx - turn.x) * camera.right + (sy - turn.y) * camera.up)};
    //| not_implemented("1.1", "camera_ray()");
    //| return {camera.position, camera.forward};
    //]
}

} // namespace raylab::lab01
