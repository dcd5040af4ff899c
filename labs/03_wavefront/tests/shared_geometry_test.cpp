// Task 3.5: shapes in shared memory give the same image, and what they cost is known beforehand.
#include "common/task/facts.h"
#include "common/task/small_scene.h"
#include "labs/03_wavefront/launch_sizing.h"
#include "labs/03_wavefront/renderer.h"
#include "labs/03_wavefront/tests/shared_shapes.h"

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

TEST(Task3_5, ShapesAreCopiedToTheBlocksOwnMemory) {
    const Scene scene = shapes(40);
    for (const int block : {32, 224}) {
        const SharedShapes found = look_at_shared_shapes(scene, block);
        for (int k = 0; k < shape_arrays; ++k)
            if (!expect_equal(fmt::format("{} lie in shared memory (1: yes)", shape_array_names[k]),
                              found.inside[k], 1,
                              fmt::format("move_to_shared() is not called for scene.{}, or not by "
                                          "each block",
                                          shape_array_names[k])))
                return;
        for (int k = 0; k < shape_arrays; ++k)
            if (!expect_equal(fmt::format("the copy of {} is the scene's, byte by byte (1: yes)",
                                          shape_array_names[k]),
                              found.same[k], 1,
                              "each array begins where the one before ends, and all threads of "
                              "the block copy their share"))
                return;
    }
}

TEST(Task3_5, TheImageIsTheSameToTheBit) {
    const Scene scene = shapes(20);
    for (const int block : {32, 100, 512}) {
        const Film a = render(scene, false, block), b = render(scene, true, block);
        expect(same_bits(a, b),
               fmt::format("with geometry in shared memory, blocks of {}, the image is another; "
                           "the likely cause: threads without a path must copy too, and none may "
                           "go on before the barrier behind the copy",
                           block));
    }
}

TEST(Task3_5, GeometryThatIsTooLargeIsRefusedWithTheFigures) {
    try {
        render(shapes(4000), true, 128);
        expect(false, "4000 spheres do not fit into 48 KiB, and should be refused");
    } catch (const SettingsError& error) {
        expect(std::string(error.what()).find("49152") != std::string::npos,
               fmt::format("that 4000 spheres are too many should be said with the limit, 49152 "
                           "bytes, but the text is: {}",
                           error.what()));
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
