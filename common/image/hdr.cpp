// Radiance HDR (RGBE): three 8-bit mantissas and a shared exponent e, v = m 2^(e - 136); rows
// packed by run lengths, a channel at a time (Ward, "Real Pixels", Graphics Gems II, 1991). Written
// by stb. Read here: stb's reader never returns from a file that ends inside a run.
#include "common/image/formats.h"

#include <stb/stb_image_write.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace raylab::formats {
namespace {

// The bytes behind the header, one after the other.
class ByteReader {
  public:
    ByteReader(const std::string& bytes, std::size_t at) : bytes_(bytes), at_(at) {}
    std::uint8_t next() {
        if (at_ >= bytes_.size()) throw std::runtime_error("it ends too early");
        return static_cast<std::uint8_t>(bytes_[at_++]);
    }
    // Whether a packed row of `width` pixels starts here: its mark is 2, 2, width.
    bool at_packed_row(int width) const {
        return width >= 8 && width < 32768 && at_ + 4 <= bytes_.size() && bytes_[at_] == 2 &&
               bytes_[at_ + 1] == 2 && bytes_[at_ + 2] == static_cast<char>(width >> 8) &&
               bytes_[at_ + 3] == static_cast<char>(width & 255);
    }

  private:
    const std::string& bytes_;
    std::size_t at_;
};

using Rgbe = std::array<std::uint8_t, 4>;

// A count above 128 is a run of (count - 128) equal bytes; any other, that many bytes as they are.
void read_packed_row(ByteReader& in, std::vector<Rgbe>& row) {
    for (int skip = 0; skip < 4; ++skip) in.next();
    for (std::size_t channel = 0; channel < 4; ++channel)
        for (std::size_t x = 0; x < row.size();) {
            const int code = in.next();
            const bool run = code > 128;
            const auto count = static_cast<std::size_t>(run ? code - 128 : code);
            if (count == 0 || count > row.size() - x)
                throw std::runtime_error("one of its rows is damaged");
            const std::uint8_t value = run ? in.next() : std::uint8_t(0);
            for (std::size_t k = 0; k < count; ++k) row[x++][channel] = run ? value : in.next();
        }
}

std::string next_line(const std::string& bytes, std::size_t& at) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string::npos || end - at > 4096)
        throw std::runtime_error("its header ends too early");
    const std::string line = bytes.substr(at, end - at);
    at = end + 1;
    return line;
}

} // namespace

// RGBE holds neither negative nor non-finite values: both become 0.
std::string encode_hdr(const Image& image) {
    std::vector<Vec3> clean = image.mean;
    for (Vec3& v : clean)
        for (int c = 0; c < 3; ++c) v[c] = std::isfinite(v[c]) && v[c] > 0 ? v[c] : 0.0f;
    std::string bytes;
    const auto append = [](void* out, void* data, int size) {
        static_cast<std::string*>(out)->append(static_cast<char*>(data),
                                               static_cast<std::size_t>(size));
    };
    stbi_write_hdr_to_func(append, &bytes, image.width, image.height, 3, &clean[0].x);
    return bytes;
}

Image decode_hdr(const std::string& bytes) {
    std::size_t at = 0;
    if (!bytes.starts_with("#?RADIANCE") && !bytes.starts_with("#?RGBE"))
        throw std::runtime_error("it does not start with '#?RADIANCE'");
    bool rgbe = false;
    for (std::string line = next_line(bytes, at); !line.empty(); line = next_line(bytes, at))
        rgbe = rgbe || line == "FORMAT=32-bit_rle_rgbe";
    const std::string resolution = next_line(bytes, at);
    int width = 0, height = 0;
    if (!rgbe || std::sscanf(resolution.c_str(), "-Y %9d +X %9d", &height, &width) != 2)
        throw std::runtime_error(
            "only RGBE files with the top row first ('-Y height +X width') are "
            "read");

    Image image = allocate(width, height, bytes.size());
    ByteReader in(bytes, at);
    std::vector<Rgbe> row(static_cast<std::size_t>(width));
    auto pixel = image.mean.begin();
    for (int y = 0; y < height; ++y) {
        if (in.at_packed_row(width))
            read_packed_row(in, row);
        else
            for (Rgbe& v : row)
                for (std::uint8_t& byte : v) byte = in.next();
        for (const Rgbe& v : row)
            *pixel++ =
                v[3] == 0 ? Vec3(0) : Vec3(v[0], v[1], v[2]) * std::ldexp(1.0f, int(v[3]) - 136);
    }
    return image;
}

} // namespace raylab::formats
