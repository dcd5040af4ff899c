#include "grader/grading/secret.h"

#include "common/cli/files.h"
#include "common/cli/sha256.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <stdexcept>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

namespace raylab::grading {

namespace {

constexpr std::size_t key_bytes = 32, block_bytes = 64; // of SHA-256

std::string random_bytes(std::size_t n) {
    std::string bytes(n, '\0');
    if (getrandom(bytes.data(), n, 0) != static_cast<ssize_t>(n))
        throw std::runtime_error("the system gives no random numbers");
    return bytes;
}

std::string sha256(const std::string& bytes) {
    Sha256 hash;
    hash.add(bytes);
    const auto digest = hash.digest();
    return {digest.begin(), digest.end()};
}

// Whole or not at all, and never readable for others: another grader may make it at the same time.
void make_key(const std::filesystem::path& file) {
    const std::string part = file.string() + "." + std::to_string(getpid());
    const int handle = open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    const std::string key = random_bytes(key_bytes);
    const bool written = handle >= 0 && write(handle, key.data(), key.size()) == ssize_t(key_bytes);
    if (handle >= 0) close(handle);
    const bool made = written && (link(part.c_str(), file.c_str()) == 0 || errno == EEXIST);
    unlink(part.c_str());
    if (!made) throw std::runtime_error(fmt::format("the key '{}' cannot be made", file.string()));
}

} // namespace

std::string read_key(const std::filesystem::path& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) {
        std::filesystem::create_directories(file.parent_path());
        make_key(file);
        if (stat(file.c_str(), &status) != 0)
            throw std::runtime_error(fmt::format("'{}': {}", file.string(), std::strerror(errno)));
    }
    if ((status.st_mode & 077) != 0)
        throw std::runtime_error(
            fmt::format("others can read the grader's key '{}': chmod 600, or remove "
                        "it, and a new one is made",
                        file.string()));
    const std::string key = read_file(file.string());
    if (key.size() < key_bytes)
        throw std::runtime_error(
            fmt::format("'{}' is no key: it has {} bytes", file.string(), key.size()));
    return key;
}

std::string hmac(const std::string& key, const std::string& message) {
    std::string padded = key.size() > block_bytes ? sha256(key) : key;
    padded.resize(block_bytes, '\0');
    std::string inner = padded, outer = padded;
    for (char& c : inner) c ^= 0x36;
    for (char& c : outer) c ^= 0x5c;
    return sha256(outer + sha256(inner + message));
}

std::uint32_t Derived::next() {
    const std::string digest = hmac(key_, fmt::format("{}#{}", purpose_, count_++));
    std::uint32_t number;
    std::memcpy(&number, digest.data(), sizeof number);
    return number;
}

double Derived::uniform(double low, double high) {
    return low + (high - low) * (next() / 4294967296.0);
}

std::string random_hex(int bytes) {
    std::string text;
    for (const unsigned char byte : random_bytes(static_cast<std::size_t>(bytes)))
        text += fmt::format("{:02x}", byte);
    return text;
}

std::uint32_t random_number() {
    std::uint32_t number;
    std::memcpy(&number, random_bytes(sizeof number).data(), sizeof number);
    return number;
}

} // namespace raylab::grading
