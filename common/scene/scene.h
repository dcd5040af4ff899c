// Scene: a validated scene on the host. It owns the arrays that SceneView points to.
#pragma once

#include "common/scene/settings.h"
#include "common/scene/view.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

// What a scene file promises about its own image: the scene is its own test.
struct Expectation {
    // The mean over the region of one channel-average (or of each channel) of the image.
    Vec3 value;                  // closed form, linear RGB
    double tolerance = 0;        // relative error allowed beside the statistical one
    std::array<int, 4> region{}; // x0, y0, x1, y1 in pixels, half open; whole film if all zero
    int spp = 0;                 // samples a pixel to render for the check
    std::string formula;         // the closed form in words, with its source
};

struct Scene {
    std::string name;   // file name without folder and extension
    std::string title;  // one line
    std::string reason; // why the scene exists
    std::string hash;   // 16 hex digits over the file and every file it names

    RenderSettings render;
    Camera camera{};
    std::vector<Sphere> spheres;
    std::vector<SphereGroup> sphere_groups; // = group_spheres(spheres)
    std::vector<Quad> quads;
    std::vector<QuadGroup> quad_groups; // = group_quads(quads)
    std::vector<Plane> planes;
    std::vector<Triangle> triangles;
    std::vector<TriangleRun> runs;
    std::vector<TriangleCorners> corners;
    std::vector<CornerColours> corner_colours;
    std::vector<Material> materials;
    std::vector<std::string> material_names;
    std::vector<Light> lights;
    std::vector<Texture> textures;
    std::vector<Vec3> texels;
    Vec3 environment_radiance = Vec3(0);
    int environment_light = -1;
    int environment_width = 0, environment_height = 0;
    float environment_turn = 0; // what rotate_deg leaves when whole columns have been moved
    std::vector<Vec3> environment_map;
    std::vector<float> environment_row_cdf, environment_column_cdf;
    std::vector<Expectation> expect;

    // Legal but probably not meant: "no light and nothing emits: the image will be black".
    std::vector<std::string> warnings;
};

// The scene's arrays in host memory. Valid as long as the scene is neither moved nor changed.
SceneView view(const Scene& scene);

} // namespace raylab
