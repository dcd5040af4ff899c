// SceneView: the scene as a kernel sees it. Flat arrays of plain structs, the same bytes on the CPU
// machine and on the GPU; Scene (scene.h) owns them on the host, DeviceScene on the device.
#pragma once

#include "common/camera/camera.h"
#include "common/geometry/quad_group.h"
#include "common/geometry/shapes.h"
#include "common/geometry/sphere_group.h"
#include "common/material/material.h"
#include "common/math/array.h"
#include "common/scene/light.h"

namespace raylab {

// What lies outside an image: the image again, the colour of its border, or its mirror image.
enum class Wrap : int { repeat, clamp, mirror };

// An image in SceneView::texels, row 0 at the bottom (v = 0), linear RGB.
struct Texture {
    int first; // index of its first texel
    int width, height;
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
};

// Light from infinitely far away. Directions map to the unit square by latitude and longitude:
// u = atan2(z, x) / 2 pi + turn (wrapped to [0, 1)), v = acos(y) / pi; row 0 of the map is the top
// (y = 1). With no map the environment is constant.
struct Environment {
    Vec3 radiance = Vec3(0); // constant radiance, or the factor on the map
    int light = -1;          // index into SceneView::lights, or -1: no environment
    int width = 0, height = 0;
    float turn = 0; // of the map, in turns; at most half a column either way
    // Cumulative distributions over the texels, in proportion to luminance * sin(theta). No texel
    // that glows has a smaller probability than load/environment_map.h says:
    Array<Vec3> map;         // width * height radiances, row by row
    Array<float> row_cdf;    // height + 1: P(row < i)
    Array<float> column_cdf; // height * (width + 1): P(column < j | row)
};

struct SceneView {
    Camera camera;
    Array<Sphere> spheres;
    Array<SphereGroup> sphere_groups; // the same spheres, side by side
    Array<Quad> quads;
    Array<QuadGroup> quad_groups; // the same quads, side by side
    Array<Plane> planes;
    Array<Triangle> triangles;
    Array<TriangleRun> runs;
    Array<TriangleCorners> corners;
    Array<CornerColours> corner_colours;
    Array<Material> materials;
    Array<Light> lights;
    Array<Texture> textures;
    Array<Vec3> texels;
    Environment environment;
};

static_assert(std::is_trivially_copyable_v<SceneView>);

} // namespace raylab
