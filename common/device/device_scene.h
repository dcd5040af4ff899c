// DeviceScene: a copy of a scene's arrays in device memory, and the SceneView that points to them.
#pragma once

#include "common/device/device_array.h"
#include "common/scene/scene.h"

namespace raylab {

class DeviceScene {
  public:
    explicit DeviceScene(const Scene& scene)
        : spheres_(scene.spheres), sphere_groups_(scene.sphere_groups), quads_(scene.quads),
          quad_groups_(scene.quad_groups), planes_(scene.planes), triangles_(scene.triangles),
          runs_(scene.runs), corners_(scene.corners), corner_colours_(scene.corner_colours),
          materials_(scene.materials), lights_(scene.lights), textures_(scene.textures),
          texels_(scene.texels), map_(scene.environment_map), row_cdf_(scene.environment_row_cdf),
          column_cdf_(scene.environment_column_cdf), view_(raylab::view(scene)) {
        point_to(view_.spheres, spheres_);
        point_to(view_.sphere_groups, sphere_groups_);
        point_to(view_.quads, quads_);
        point_to(view_.quad_groups, quad_groups_);
        point_to(view_.planes, planes_);
        point_to(view_.triangles, triangles_);
        point_to(view_.runs, runs_);
        point_to(view_.corners, corners_);
        point_to(view_.corner_colours, corner_colours_);
        point_to(view_.materials, materials_);
        point_to(view_.lights, lights_);
        point_to(view_.textures, textures_);
        point_to(view_.texels, texels_);
        point_to(view_.environment.map, map_);
        point_to(view_.environment.row_cdf, row_cdf_);
        point_to(view_.environment.column_cdf, column_cdf_);
    }

    const SceneView& view() const { return view_; }

  private:
    template <class T> static void point_to(Array<T>& array, const DeviceArray<T>& memory) {
        array = {memory.data(), static_cast<int>(memory.size())};
    }

    DeviceArray<Sphere> spheres_;
    DeviceArray<SphereGroup> sphere_groups_;
    DeviceArray<Quad> quads_;
    DeviceArray<QuadGroup> quad_groups_;
    DeviceArray<Plane> planes_;
    DeviceArray<Triangle> triangles_;
    DeviceArray<TriangleRun> runs_;
    DeviceArray<TriangleCorners> corners_;
    DeviceArray<CornerColours> corner_colours_;
    DeviceArray<Material> materials_;
    DeviceArray<Light> lights_;
    DeviceArray<Texture> textures_;
    DeviceArray<Vec3> texels_;
    DeviceArray<Vec3> map_;
    DeviceArray<float> row_cdf_;
    DeviceArray<float> column_cdf_;
    SceneView view_;
};

} // namespace raylab
