// The text of a source file that somebody has sent.
#pragma once

#include <filesystem>
#include <string>

namespace raylab {

// UTF-8 without a byte order mark, lines that end in '\n'. Throws SubmissionError for text in
// UTF-16 and for what is no text.
std::string source_text(std::string bytes, const std::string& name);

// The bytes of a regular file, at most `most`. Follows no link, waits for no pipe. Throws
// SubmissionError.
std::string read_sent_file(const std::filesystem::path& path, const std::string& name,
                           std::uint64_t most);

} // namespace raylab
