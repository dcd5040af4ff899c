// A folder for what is compiled, removed afterwards.
#pragma once

#include <filesystem>
#include <string>

namespace raylab::app {

class WorkFolder {
  public:
    // In the system's folder for temporary files, or `keep`, which is made if need be and stays.
    // Also removes what a raylab that was killed has left. Throws
    // std::filesystem::filesystem_error.
    explicit WorkFolder(const std::string& keep);
    ~WorkFolder();
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    bool stays_;
};

} // namespace raylab::app
