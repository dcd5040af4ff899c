// raylab-draw: renders a scene file as often as it is asked, for the grader. The submission's labs
// are linked into one such program, which runs in the sandbox, the solution's into another, which
// makes references.
//
//     raylab-draw LAB SCENE IMAGE.pfm LEDGER.json --seed N --spp N [options of `raylab render`]
#include "app/labs.h"
#include "app/options.h"
#include "common/cli/files.h"
#include "common/image/image_file.h"
#include "common/load/load.h"
#include "common/render/render.h"

#include <fmt/format.h>

namespace raylab::app {

namespace {

struct DrawOptions {
    std::string lab, scene, image, ledger;
    std::uint32_t seed = 1;
    int spp = 1;
    MachineSettings machine;
};

void draw(const DrawOptions& options) {
    const Lab& lab = find_lab(options.lab);
    const Scene scene = load_scene(options.scene);
    const std::unique_ptr<Renderer> renderer = lab.make(scene, options.machine);
    const Render drawn = render(*renderer, scene, scene.camera, options.seed, options.spp);
    write_image(drawn.image, options.image);
    write_file(options.ledger, to_json(drawn.ledger) + "\n");
}

} // namespace

} // namespace raylab::app

int main(int argc, char** argv) {
    using namespace raylab::app;
    CLI::App cli("draws a picture for the grader", "raylab-draw");
    DrawOptions options;
    cli.add_option("LAB", options.lab)->required();
    cli.add_option("SCENE", options.scene)->required();
    cli.add_option("IMAGE", options.image)->required();
    cli.add_option("LEDGER", options.ledger)->required();
    cli.add_option("--seed", options.seed)->required();
    cli.add_option("--spp", options.spp)->required();
    add_machine_options(cli, options.machine);
    add_wavefront_options(cli, options.machine.wavefront);
    add_accel_options(cli, options.machine.accel);
    CLI11_PARSE(cli, argc, argv);
    try {
        draw(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    return 0;
}
