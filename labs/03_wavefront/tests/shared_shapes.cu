#include "labs/03_wavefront/tests/shared_shapes.h"

#include "common/device/device_scene.h"
#include "labs/03_wavefront/shared_geometry.h"

namespace raylab::lab03 {

namespace {

// One thread tells whether the shapes it was given lie where its block's shared memory is.
__global__ void where_shapes_lie(const SceneView* scene, SharedShapes* found) {
    __shared__ float4 memory[512];
    const SceneView shared = geometry_in_shared_memory<feature::all>(*scene, memory);
    __syncthreads();
    if (threadIdx.x > 0) return;
    const auto* first = reinterpret_cast<const unsigned char*>(memory);
    const auto* spheres = reinterpret_cast<const unsigned char*>(shared.spheres.data);
    const auto* triangles = reinterpret_cast<const unsigned char*>(shared.triangles.data);
    found->inside = spheres >= first && spheres < first + sizeof memory && triangles >= first &&
                    triangles < first + sizeof memory;
    found->same = shared.spheres[2].center.x == scene->spheres[2].center.x &&
                  shared.quads[0].v[2].y == scene->quads[0].v[2].y &&
                  shared.planes[0].normal.y == scene->planes[0].normal.y &&
                  shared.triangles[0].v[1].z == scene->triangles[0].v[1].z;
}

} // namespace

SharedShapes look_at_shared_shapes(const Scene& scene, int block) {
    const DeviceScene device(scene);
    const DeviceArray<SceneView> view(std::span(&device.view(), 1));
    DeviceArray<SharedShapes> found(1);
    where_shapes_lie<<<1, block>>>(view.data(), found.data());
    check(cudaDeviceSynchronize(), "where_shapes_lie");
    return found.to_host().front();
}

} // namespace raylab::lab03
