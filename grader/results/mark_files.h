// The files of marks that a command line asks for: --write FORMAT:FILE.
#pragma once

#include "grader/results/marks.h"

#include <string>
#include <vector>

namespace raylab {

class MarkFiles {
  public:
    // Throws FileError for a format that is not there and for a file that cannot be written.
    explicit MarkFiles(const std::vector<std::string>& asked);
    void write(const Marks& marks) const;

  private:
    std::vector<std::pair<std::string, std::string>> files_; // format and file
};

} // namespace raylab
