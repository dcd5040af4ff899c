// What a submission must not know beforehand: the grader's key, and what is derived from it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace raylab::grading {

// The grader's key, 32 bytes. Read from a file that its owner alone can read; made there if there
// is none. Throws std::runtime_error if others can read it. It never stands in an argument or in
// the environment, which /proc shows.
std::string read_key(const std::filesystem::path& file);

// RFC 2104 with SHA-256: the digest, 32 bytes.
std::string hmac(const std::string& key, const std::string& message);

// Numbers that follow from a key and a purpose, and from nothing else.
class Derived {
  public:
    Derived(std::string key, std::string purpose)
        : key_(std::move(key)), purpose_(std::move(purpose)) {}
    std::uint32_t next();
    double uniform(double low, double high); // in [low, high)

  private:
    std::string key_, purpose_;
    int count_ = 0;
};

// That many random bytes of the system, in hex.
std::string random_hex(int bytes);
std::uint32_t random_number();

} // namespace raylab::grading
