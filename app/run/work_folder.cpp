// The folder's name says whose it is; see work_folder.h.
#include "app/run/work_folder.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <unistd.h>

namespace raylab::app {

namespace fs = std::filesystem;

static const std::string prefix = "raylab-run-"; // and the number of the process

static void remove_leftovers(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (error || !name.starts_with(prefix)) continue;
        const int process = std::atoi(name.c_str() + prefix.size());
        if (process > 0 && kill(process, 0) != 0 && errno == ESRCH)
            fs::remove_all(entry->path(), error);
    }
}

WorkFolder::WorkFolder(const std::string& keep) : stays_(!keep.empty()) {
    const fs::path temporary = fs::temp_directory_path();
    remove_leftovers(temporary);
    path_ = stays_ ? fs::absolute(keep) : temporary / (prefix + std::to_string(getpid()));
    fs::create_directories(path_);
}

WorkFolder::~WorkFolder() {
    std::error_code error;
    if (!stays_) fs::remove_all(path_, error);
}

} // namespace raylab::app
