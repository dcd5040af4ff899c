// SHA-256 (FIPS 180-4): a name for bytes that nobody can give to other bytes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace raylab {

class Sha256 {
  public:
    void add(std::string_view bytes);
    std::array<std::uint8_t, 32> digest() const; // of all that was added so far
    std::string hex() const;                     // the digest in 64 hex digits

  private:
    void compress(const std::uint8_t* block);

    std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                           0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<std::uint8_t, 64> block_ =
        {}; // the first bytes_ % 64 of it are yet to be compressed
    std::uint64_t bytes_ = 0;
};

} // namespace raylab
