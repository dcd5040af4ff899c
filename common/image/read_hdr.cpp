// Radiance HDR: three 8-bit mantissas and a shared exponent e, v = m 2^(e - 136); rows packed by
// run lengths (Ward, "Real Pixels", Graphics Gems II, 1991).
#include "common/image/decode.h"
#include "common/image/hdr_header.h"

#include <array>
#include <cmath>
#include <vector>

namespace raylab {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

// The bytes behind the header, one after the other.
class ByteReader {
  public:
    ByteReader(std::string_view bytes, std::size_t at) : bytes_(bytes), at_(at) {}
    std::uint8_t next() {
        if (at_ >= bytes_.size()) throw DecodeError("it ends too early");
        return static_cast<std::uint8_t>(bytes_[at_++]);
    }
    Rgbe next_pixel() { return {next(), next(), next(), next()}; }
    // Whether a row of `length` pixels starts here that is packed in the new way, a channel at a
    // time: its mark is 2, 2, length.
    bool at_packed_row(std::size_t length) const {
        return length >= 8 && length < 32768 && at_ + 4 <= bytes_.size() && bytes_[at_] == 2 &&
               bytes_[at_ + 1] == 2 && bytes_[at_ + 2] == static_cast<char>(length >> 8) &&
               bytes_[at_ + 3] == static_cast<char>(length & 255);
    }

  private:
    std::string_view bytes_;
    std::size_t at_;
};

[[noreturn]] void damaged() { throw DecodeError("one of its rows is damaged"); }

// A count above 128 is a run of (count - 128) equal bytes; any other, that many bytes as they are.
void read_packed_row(ByteReader& in, std::vector<Rgbe>& row) {
    in.next_pixel(); // the mark
    for (std::size_t channel = 0; channel < 4; ++channel)
        for (std::size_t x = 0; x < row.size();) {
            const int code = in.next();
            const bool run = code > 128;
            const auto count = static_cast<std::size_t>(run ? code - 128 : code);
            if (count == 0 || count > row.size() - x) damaged();
            const std::uint8_t value = run ? in.next() : std::uint8_t(0);
            for (std::size_t k = 0; k < count; ++k) row[x++][channel] = run ? value : in.next();
        }
}

// Pixel by pixel. (1, 1, 1, n) is no colour, since the largest mantissa of one is at least 128: it
// repeats the pixel before n times, one that follows another 256 n times, and so on.
void read_plain_row(ByteReader& in, std::vector<Rgbe>& row) {
    int shift = 0;
    for (std::size_t x = 0; x < row.size();) {
        const Rgbe pixel = in.next_pixel();
        if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
            const std::size_t count = std::size_t(pixel[3]) << shift;
            if (x == 0 || shift > 16 || count > row.size() - x) damaged();
            for (std::size_t k = 0; k < count; ++k, ++x) row[x] = row[x - 1];
            shift += 8;
        } else {
            row[x++] = pixel;
            shift = 0;
        }
    }
}

// From CIE X, Y, Z to linear sRGB (IEC 61966-2-1, D65). A colour that no screen shows has a
// negative channel; light has none, so that becomes 0.
DVec3 srgb_from_xyz(DVec3 c) {
    return glm::max(DVec3(0), DVec3(3.2404542 * c.x - 1.5371385 * c.y - 0.4985314 * c.z,
                                    -0.9692660 * c.x + 1.8760108 * c.y + 0.0415560 * c.z,
                                    0.0556434 * c.x - 0.2040259 * c.y + 1.0572252 * c.z));
}

Vec3 radiance(const Rgbe& v, const HdrHeader& header) {
    if (v[3] == 0) return Vec3(0);
    const DVec3 c = DVec3(v[0], v[1], v[2]) * std::ldexp(1.0, int(v[3]) - 136) / header.exposure;
    return Vec3(header.is_xyz ? srgb_from_xyz(c) : c);
}

// Pixels in the order of the file to rows from the top, each from the left.
std::vector<Vec3> upright(const std::vector<Vec3>& pixels, const HdrHeader& header) {
    const auto width = std::size_t(header.width), height = std::size_t(header.height);
    std::vector<Vec3> rows(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::size_t x = header.columns_first ? i / height : i % width;
        const std::size_t y = header.columns_first ? i % height : i / width;
        rows[(header.downwards ? y : height - 1 - y) * width +
             (header.rightwards ? x : width - 1 - x)] = pixels[i];
    }
    return rows;
}

} // namespace

Image decode_hdr(std::string_view bytes, PictureLimits limits) {
    const HdrHeader header = read_hdr_header(bytes);
    check_picture_size(header.width, header.height, bytes.size(), limits);
    Image image;
    image.width = int(header.width);
    image.height = int(header.height);
    ByteReader in(bytes, header.end);
    // The picture grows with what the file holds, whatever its header says.
    std::vector<Rgbe> row(std::size_t(header.columns_first ? header.height : header.width));
    while (image.mean.size() < image.pixels()) {
        if (in.at_packed_row(row.size()))
            read_packed_row(in, row);
        else
            read_plain_row(in, row);
        for (const Rgbe& pixel : row) image.mean.push_back(radiance(pixel, header));
    }
    if (header.columns_first || !header.rightwards || !header.downwards)
        image.mean = upright(image.mean, header);
    return image;
}

} // namespace raylab
