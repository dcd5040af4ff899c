// One program at a time works in a folder.
#pragma once

#include <filesystem>

namespace raylab {

// Holds a lock on the folder, which the system takes back when the program ends, however it ends.
// Makes the folder if it is not there.
class FolderLock {
  public:
    explicit FolderLock(const std::filesystem::path& folder); // throws std::system_error
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    bool held() const { return handle_ >= 0; } // false: another program has it

  private:
    int handle_;
};

} // namespace raylab
