// What all submissions of a lab stand on: the tree that its students got, with stubs, built once.
#pragma once

#include "grader/course/lab_sheet.h"
#include "grader/sandbox/tier.h"

#include <functional>
#include <memory>

namespace raylab::grading {

// A lock on a folder: many graders read what one has built.
class FolderLock {
  public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    void share();      // with others that share it
    void take_alone(); // waits until nobody else has it

  private:
    int handle_;
};

struct BaseBuild {
    LabSheet sheet;                   // of the students' tree
    std::filesystem::path folder;     // has tree/, build/, symbols (object_check.h)
    std::shared_ptr<FolderLock> lock; // as long as this lives, nobody changes the folder
    std::filesystem::path tree() const { return folder / "tree"; }
    std::filesystem::path build() const { return folder / "build"; }
    std::filesystem::path lab() const { return sheet.path(); }
    std::filesystem::path tests() const {
        return build() / "labs" / sheet.folder / sheet.test_target;
    }
};

// The programs that a submission is built to, relative to a build folder.
std::filesystem::path draw_program();

// Writes and builds it below `cache`, unless that was done for these sources: a first build takes
// minutes. Another grader that is about the same waits. Where the sandbox cannot map files,
// submissions are built in the folder itself, one at a time. `built` is called when something was
// built. Throws std::runtime_error, CourseError.
BaseBuild prepare_base(const LabSheet& sheet, const std::filesystem::path& cache,
                       const sandbox::Isolation& isolation,
                       const std::function<void(const BaseBuild&)>& built);

} // namespace raylab::grading
