#include "grader/submissions/source_text.h"

#include "grader/submissions/submission_error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace raylab {

std::string source_text(std::string bytes, const std::string& name) {
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
        throw SubmissionError(fmt::format("{} is text in UTF-16; save it as UTF-8", name));
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
    if (bytes.find('\0') != std::string::npos)
        throw SubmissionError(
            fmt::format("{} is no text: it holds zero bytes; send the source", name));
    std::string text;
    text.reserve(bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const bool line_break = bytes[i] == '\r';
        if (line_break && i + 1 < bytes.size() && bytes[i + 1] == '\n') continue;
        text += line_break ? '\n' : bytes[i];
    }
    return text;
}

std::string read_sent_file(const std::filesystem::path& path, const std::string& name,
                           std::uint64_t most) {
    const auto fail = [&name](const std::string& why) {
        throw SubmissionError(fmt::format("{} is not read: {}", name, why));
    };
    const int file = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) fail(std::strerror(errno));
    struct stat status = {};
    const bool is_file = fstat(file, &status) == 0 && S_ISREG(status.st_mode);
    std::string bytes;
    bool failed = !is_file;
    char block[1 << 14];
    while (!failed && bytes.size() <= most) {
        const ssize_t n = read(file, block, sizeof block);
        if (n < 0 && errno == EINTR) continue;
        failed = n < 0;
        if (n <= 0) break;
        bytes.append(block, static_cast<std::size_t>(n));
    }
    close(file);
    if (!is_file) fail("it is no regular file");
    if (failed) fail("the disk gave an error");
    if (bytes.size() > most) fail(fmt::format("it has more than {} bytes", most));
    return bytes;
}

} // namespace raylab
