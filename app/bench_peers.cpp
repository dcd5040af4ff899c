#include "app/bench_peers.h"

#include "app/export_blender.h"
#include "app/labs.h"
#include "app/python_parts.h"
#include "common/cli/files.h"
#include "common/cli/process.h"
#include "common/image/image_file.h"

#include <fmt/format.h>

#include <filesystem>

namespace raylab::app {

namespace {

using bench::ContestantError;

// What distinguishes the peers.
struct Peer {
    const char* name;
    std::string PeerSettings::*program;
    std::vector<std::string> version; // arguments that make it print its version in the first line
    std::vector<ExportedFile> (*export_scene)(const Scene&);
    // Arguments of one render.
    std::vector<std::string> (*render)(const PeerSettings& settings, int spp, std::uint32_t seed,
                                       const std::string& output);
    const char* how_to_get_it;
};

std::vector<std::string> render_with_cycles(const PeerSettings& s, int spp, std::uint32_t seed,
                                            const std::string& output) {
    return {"-b",
            "--factory-startup",
            "--python-exit-code",
            "3",
            "--python",
            s.folder + "/scene.py",
            "--",
            "--spp",
            std::to_string(spp),
            "--seed",
            std::to_string(seed),
            "--threads",
            std::to_string(s.threads),
            "-o",
            output};
}

template <const char* const& variant>
std::vector<std::string> render_with_mitsuba(const PeerSettings& s, int spp, std::uint32_t seed,
                                             const std::string& output) {
    return {"-c",
            run_mitsuba_py,
            variant,
            s.folder + "/scene.xml",
            std::to_string(spp),
            std::to_string(seed),
            std::to_string(s.threads),
            output};
}

constexpr const char* llvm = "llvm_ad_rgb";
constexpr const char* scalar = "scalar_rgb";

const std::vector<Peer>& peers() {
    static const char* const mitsuba = "pip install mitsuba, and name that python with --python; "
                                       "llvm needs libllvm19 or newer";
    static const std::vector<Peer> all = {
        {"cycles",
         &PeerSettings::blender,
         {"--version"},
         blender_files,
         render_with_cycles,
         "install Debian's blender, or name it with --blender"},
        {"mitsuba_llvm",
         &PeerSettings::python,
         {"-c", run_mitsuba_py, llvm},
         mitsuba_files,
         render_with_mitsuba<llvm>,
         mitsuba},
        {"mitsuba_scalar",
         &PeerSettings::python,
         {"-c", run_mitsuba_py, scalar},
         mitsuba_files,
         render_with_mitsuba<scalar>,
         mitsuba},
    };
    return all;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

// The first line that the program prints about its version. Throws ContestantError if it does not
// run.
std::string ask_version(const Peer& peer, const PeerSettings& settings) {
    std::vector<std::string> command = {settings.*peer.program};
    command.insert(command.end(), peer.version.begin(), peer.version.end());
    const ProcessResult result = run_process(command, {60});
    if (!result.succeeded())
        throw ContestantError(fmt::format("not here: '{}' {}; {}", settings.*peer.program,
                                          why_failed(result), peer.how_to_get_it));
    return first_line(result.output);
}

void write_scene(const Peer& peer, const Scene& scene, const std::string& folder) {
    try {
        for (const ExportedFile& file : peer.export_scene(scene))
            write_file(folder + "/" + file.name, file.bytes);
    } catch (const UsageError& error) {
        throw ContestantError(fmt::format("{} {}", scene.name, error.what()));
    }
}

bench::Drawn render(const Peer& peer, const PeerSettings& settings, int spp, std::uint32_t seed) {
    const std::string output = settings.folder + "/image.exr";
    std::error_code ignored;
    std::filesystem::remove(output, ignored);
    std::vector<std::string> command = {settings.*peer.program};
    for (std::string& word : peer.render(settings, spp, seed, output))
        command.push_back(std::move(word));
    const ProcessResult result = run_process(command, {settings.limit});
    if (!result.succeeded())
        throw ContestantError(fmt::format("failed: '{}' at {} spp: {}", settings.*peer.program, spp,
                                          why_failed(result)));
    bench::Drawn drawn;
    drawn.seconds = result.seconds;
    try {
        drawn.image = read_image(output);
    } catch (const ImageError& error) {
        throw ContestantError(
            fmt::format("failed: '{}' left no image: {}", settings.*peer.program, error.what()));
    }
    return drawn;
}

} // namespace

const std::vector<std::string>& peer_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> result;
        for (const Peer& peer : peers()) result.push_back(peer.name);
        return result;
    }();
    return names;
}

bench::Contestant peer_contestant(const std::string& name, const Scene& scene,
                                  const PeerSettings& settings) {
    for (const Peer& peer : peers()) {
        if (name != peer.name) continue;
        const std::string version = ask_version(peer, settings);
        PeerSettings own = settings;
        own.folder += "/" + scene.name + "_" + name;
        std::filesystem::create_directories(own.folder);
        write_scene(peer, scene, own.folder);
        return {name, version,
                [&peer, own](int spp, std::uint32_t seed) { return render(peer, own, spp, seed); }};
    }
    throw UsageError(fmt::format("there is no peer '{}'", name));
}

} // namespace raylab::app
