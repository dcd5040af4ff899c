// Archives that students and platforms send: zip, and tar, plain or packed. Read by libarchive,
// which never writes a file here: what is taken goes where the caller says.
#pragma once

#include "grader/submissions/item.h"

#include <functional>

namespace raylab {

// Gets each entry in turn; returns where its bytes go, or nothing if they are to be skipped.
using Sink = std::function<void(std::string_view bytes)>;
using TakeEntry = std::function<Sink(const Item& entry)>;

// Throws SubmissionError for what is no archive, is damaged, has a password or passes a limit; at
// once, not after all has been unpacked. `name` is for errors.
void read_archive(const std::filesystem::path& file, const std::string& name,
                  const UnpackLimits& limits, const TakeEntry& take);
void read_archive_bytes(std::string_view bytes, const std::string& name, const UnpackLimits& limits,
                        const TakeEntry& take);

// The archive's files; those that `keep` takes lie in `folder` under numbers, so that no name of
// theirs reaches the disk.
std::vector<Item> unpacked_items(const std::filesystem::path& file, const std::string& name,
                                 const std::filesystem::path& folder, const UnpackLimits& limits,
                                 const std::function<bool(const Item& item)>& keep);

} // namespace raylab
