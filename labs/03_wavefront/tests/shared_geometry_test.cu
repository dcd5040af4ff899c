// Task 3.5: shapes in shared memory give the same image, and what they cost is known beforehand.
#include "common/device/device_scene.h"
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/03_wavefront/launch_sizing.h"
#include "labs/03_wavefront/renderer.h"
#include "labs/03_wavefront/shared_geometry.h"

#include <cstring>

namespace raylab::lab03 {

namespace {

using namespace task;

Scene shapes(int spheres) {
    std::string text =
        R"({"kind": "plane", "point": [0, -1, 0], "normal": [0, 1, 0], "material": "grey"},
           {"kind": "quad", "vertices": [[-1, 2, -1], [1, 2, -1], [1, 2, 1], [-1, 2, 1]],
            "material": "lamp"},
           {"kind": "triangle", "vertices": [[-2, -1, -1], [0, -1, -1], [-1, 2, -1]],
            "material": "grey"})";
    for (int i = 0; i < spheres; ++i)
        text += fmt::format(R"(, {{"kind": "sphere", "center": [{}, 0, 0], "radius": 0.01,
                                  "material": "grey"}})",
                            0.05 * i);
    return small_scene({.materials = R"("grey": {"kind": "diffuse", "reflectance": [0.5, 0.5, 0.5]},
            "lamp": {"kind": "diffuse", "reflectance": [0, 0, 0], "emission": [3, 3, 3]})",
                        .shapes = text,
                        .render = R"("max_depth": 5, "spp": 1)"});
}

Film render(const Scene& scene, bool shared, int block) {
    const std::unique_ptr<Renderer> renderer = make_renderer(
        scene,
        {.threads = 1, .block_size = block, .wavefront = {.pool = 100, .shared_geometry = shared}});
    renderer->add_iteration();
    return renderer->film();
}

// One thread tells whether the shapes it was given lie where its block's shared memory is.
__global__ void where_shapes_lie(const SceneView* scene, int* inside, int* same) {
    __shared__ float4 memory[512];
    const SceneView shared = geometry_in_shared_memory<feature::all>(*scene, memory);
    __syncthreads();
    if (threadIdx.x > 0) return;
    const auto* first = reinterpret_cast<const unsigned char*>(memory);
    const auto* spheres = reinterpret_cast<const unsigned char*>(shared.spheres.data);
    const auto* triangles = reinterpret_cast<const unsigned char*>(shared.triangles.data);
    *inside = spheres >= first && spheres < first + sizeof memory && triangles >= first &&
              triangles < first + sizeof memory;
    *same = shared.spheres[2].center.x == scene->spheres[2].center.x &&
            shared.quads[0].v[2].y == scene->quads[0].v[2].y &&
            shared.planes[0].normal.y == scene->planes[0].normal.y &&
            shared.triangles[0].v[1].z == scene->triangles[0].v[1].z;
}

TEST(Task3_5, ShapesAreCopiedToTheBlocksOwnMemory) {
    const Scene scene = shapes(40);
    const DeviceScene device(scene);
    ASSERT_LE(geometry_bytes(device.view()), 512 * sizeof(float4));
    const DeviceArray<SceneView> view(std::span(&device.view(), 1));
    DeviceArray<int> inside(1), same(1);
    for (const int block : {32, 224}) {
        where_shapes_lie<<<1, block>>>(view.data(), inside.data(), same.data());
        check(cudaDeviceSynchronize(), "where_shapes_lie");
        expect_equal("shapes lie in shared memory (1: yes)", inside.to_host()[0], 1,
                     "move_to_shared() points the arrays of the returned scene there");
        expect_equal("and are the scene's (1: yes)", same.to_host()[0], 1,
                     "each array begins where the one before ends, rounded up to 16 bytes");
    }
}

TEST(Task3_5, TheImageIsTheSameToTheBit) {
    const Scene scene = shapes(20);
    for (const int block : {32, 100, 512}) {
        const Film a = render(scene, false, block), b = render(scene, true, block);
        expect(std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(FilmPixel)) ==
                   0,
               fmt::format("with geometry in shared memory, blocks of {}, the image is another; "
                           "the likely cause: threads without a path must copy too",
                           block));
    }
}

TEST(Task3_5, GeometryThatIsTooLargeIsRefusedWithTheFigures) {
    try {
        render(shapes(4000), true, 128);
        FAIL() << "4000 spheres do not fit into 48 KiB";
    } catch (const SettingsError& error) {
        EXPECT_NE(std::string(error.what()).find("49152"), std::string::npos) << error.what();
    }
}

// "Why might this be a bad idea in some cases?" A multiprocessor with 100 KiB of shared memory
// holds 16 blocks of 128 threads; when each wants a copy of 20 KiB, it holds 5.
TEST(Task3_5, CopiesCostOccupancy) {
    const MultiprocessorLimits multiprocessor = {2048, 32, 65536, 100 << 10};
    expect_equal("blocks that fit without a copy", blocks_that_fit(multiprocessor, {128, 32, 0}),
                 16, "task 3.6");
    expect_equal("blocks that fit with a copy of 20 KiB each",
                 blocks_that_fit(multiprocessor, {128, 32, 20 << 10}), 5, "task 3.6");
}

} // namespace

} // namespace raylab::lab03
