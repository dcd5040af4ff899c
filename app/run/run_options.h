// What `raylab run` was asked for.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace raylab::app {

enum class Format { text, json, sarif, github };

struct RunOptions {
    std::vector<std::string> inputs; // files and folders, as given
    std::string machine = "plain";   // plain, bounds, races, order or all
    std::string order;               // forward, reverse, random; empty: the program's own
    unsigned long long seed = 1;     // of the order random
    std::vector<std::string> include_folders, defines;
    Format format = Format::text;
    bool gdb = false;                   // start the debugger instead
    bool raw = false;                   // show what the sanitizers wrote
    double time_limit = 20;             // seconds
    std::string keep;                   // a folder for what was compiled; empty: removed
    std::vector<std::string> arguments; // of the program
};

// Where raylab's tree is.
struct Tree {
    std::filesystem::path root;
};

// What is wrong with the options or with the program: exit code 2. One sentence or more.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace raylab::app
