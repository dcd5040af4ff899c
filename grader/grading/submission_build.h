// A submission laid over the students' tree, and built in the sandbox.
#pragma once

#include "grader/grading/base_build.h"
#include "grader/sandbox/sandbox.h"
#include "grader/sandbox/work_folder.h"

namespace raylab::grading {

class SubmissionBuild {
  public:
    // Lays the named files of `folder` over a fresh copy of the lab and of the build folder. A file
    // that is the same as the stub is left alone: it is compiled already. Throws
    // std::runtime_error.
    SubmissionBuild(const BaseBuild& base, const std::filesystem::path& folder,
                    const std::vector<std::string>& files, const sandbox::Isolation& isolation);
    ~SubmissionBuild();

    // Runs the compiler in the sandbox.
    const sandbox::Outcome& build();

    std::string compiler_errors() const;

    // The object files that are not those of the base, relative to build_folder().
    std::vector<std::string> changed_objects() const;
    std::filesystem::path build_folder() const;

    // The lab as it was built: its sheet, and the root that labs/FOLDER lies in.
    LabSheet sheet() const;

    static sandbox::Limits limits();

  private:
    std::filesystem::path temporary() const; // the compiler's, where the tier cannot map /tmp

    const BaseBuild& base_;
    const sandbox::Isolation& isolation_;
    sandbox::WorkFolder work_; // root/labs/FOLDER, build, tmp
    sandbox::Outcome outcome_;
};

} // namespace raylab::grading
