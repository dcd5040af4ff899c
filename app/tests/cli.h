// The program as a test meets it: run in a shell, in a folder of its own.
#pragma once

#include "app/tests/shell.h"
#include "common/cli/tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace raylab::app {

namespace fs = std::filesystem;

// Runs `raylab ARGUMENTS` in a shell.
inline Outcome raylab(const std::string& arguments) {
    return run_in_shell(std::string(RAYLAB_PROGRAM) + " " + arguments);
}

class Cli : public testing::Test {
  protected:
    std::string in(const std::string& name) const { return (folder / name).string(); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(in(name)) << text;
    }

    // A legal scene in which one part can be replaced.
    void write_scene(const std::string& name, const std::string& from = "",
                     const std::string& to = "") const {
        std::string text = R"({
    "version": 1, "title": "t", "reason": "r",
    "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 40},
    "film": {"width": 8, "height": 8},
    "render": {"max_depth": 4, "spp": 1},
    "materials": {"white": {"kind": "diffuse", "reflectance": [0.8, 0.8, 0.8]}},
    "shapes": [{"kind": "sphere", "center": [0, 0, 0], "radius": 1, "material": "white"}],
    "lights": [{"kind": "environment", "radiance": [1, 1, 1]}]
})";
        if (!from.empty()) {
            const std::size_t at = text.find(from);
            ASSERT_NE(at, std::string::npos) << from;
            text.replace(at, from.size(), to);
        }
        write(name, text);
    }

    void expect_refused(const std::string& arguments, const std::vector<std::string>& words) const {
        const Outcome outcome = raylab(arguments);
        EXPECT_EQ(outcome.code, 2) << arguments << "\n" << outcome.text;
        for (const std::string& word : words)
            EXPECT_NE(outcome.text.find(word), std::string::npos)
                << arguments << "\nshould say: " << word << "\nsaid: " << outcome.text;
        EXPECT_FALSE(fs::exists(in("o.exr"))) << arguments;
    }

    TemporaryFolder temporary;
    const fs::path folder = temporary.path();
};

} // namespace raylab::app
