// The platforms that `raylab autograder` makes packages for, and what each package consists of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raylab::app {

// A file of a package, made of a template in this folder.
struct PackageFile {
    std::string name; // in the package: "image/run.sh"
    std::string made_of;
    bool executable = false;
};

struct Platform {
    std::string title;  // "Gradescope"
    std::string format; // of --for and of --write
    std::vector<PackageFile> files;
    // Below, of a platform that grades; empty of one that checks, whose package has no secrets.
    std::string secrets;    // folder in the package for the tree with its solutions, and the key
    std::string run;        // the program that the platform starts
    std::string root;       // the platform's folder
    std::string submission; // the student's files, below root
    std::string source;     // where the package's files lie when setup.sh runs
    int limit_seconds = 0;  // for a submission; of every platform

    bool grades() const { return !source.empty(); }
};

const std::vector<Platform>& platforms();

// The platform of this format. Throws FileError (bad_usage) with the names there are.
const Platform& platform_of(const std::string& format);

} // namespace raylab::app
