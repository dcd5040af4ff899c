#include "app/errors.h"

#include "app/labs.h"
#include "common/cli/files.h"
#include "common/cli/memory.h"
#include "common/image/image_file.h"
#include "common/load/scene_error.h"

#include <fmt/format.h>

#include <new>

namespace raylab::app {

namespace {

ExitCode say(const std::exception& error, ExitCode code) {
    fmt::print(stderr, "raylab: {}\n", error.what());
    return code;
}

} // namespace

ExitCode report_exception() {
    try {
        throw;
    } catch (const UsageError& error) {
        return say(error, ExitCode::bad_usage);
    } catch (const SettingsError& error) {
        return say(error, ExitCode::bad_usage);
    } catch (const SceneError& error) {
        return say(error, ExitCode::bad_usage);
    } catch (const ImageError& error) {
        return say(error, ExitCode::bad_usage);
    } catch (const FileError& error) {
        return say(error, error.code);
    } catch (const std::filesystem::filesystem_error& error) {
        const FileError translated = file_error(error);
        return say(translated, translated.code);
    } catch (const std::bad_alloc&) {
        const AvailableMemory available = available_memory();
        fmt::print(
            stderr,
            "raylab: out of memory: {} were in use, {} are available now ({}); free some, or "
            "ask for a smaller film (--width, --height) or a scene of fewer triangles\n",
            human_bytes(double(peak_memory())), human_bytes(double(available.bytes)),
            available.limit);
        return ExitCode::tool_failed;
    } catch (const std::exception& error) {
        return say(error, ExitCode::tool_failed);
    }
}

} // namespace raylab::app
