#include "common/load/jpeg.h"

#include "common/image/decode.h"

#include <fmt/format.h>
#include <turbojpeg.h>

#include <memory>

namespace raylab {
namespace {

using Decoder = std::unique_ptr<void, decltype(&tjDestroy)>;

Decoder make_decoder() { return {tjInitDecompress(), tjDestroy}; }

[[noreturn]] void fail(const Decoder& decoder) {
    throw DecodeError(fmt::format("it is damaged ({})", tjGetErrorStr2(decoder.get())));
}

const unsigned char* data(std::string_view bytes) {
    return reinterpret_cast<const unsigned char*>(bytes.data());
}

// What the library does not tell. The file is a row of segments (ITU-T T.81, B.1.1): FF, a marker,
// and for those before the image a length that counts itself.
struct Segments {
    int bits = 8;
    bool is_lossless = false, is_adobe = false;
};

Segments read_segments(std::string_view bytes) {
    Segments found;
    const auto byte = [&](std::size_t at) {
        return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
    };
    constexpr int start_of_scan = 0xDA;
    for (std::size_t at = 2; at + 4 <= bytes.size();) {
        if (byte(at) != 0xFF || byte(at + 1) == 0xFF || byte(at + 1) == 0) { // filling
            ++at;
            continue;
        }
        const int marker = byte(at + 1);
        if (marker == start_of_scan) break;
        const bool is_frame =
            marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
        if (is_frame) {
            found.bits = byte(at + 4);
            found.is_lossless = marker % 4 == 3; // C3, C7, CB, CF
        } else if (marker == 0xEE && bytes.substr(at + 4, 5) == "Adobe") {
            found.is_adobe = true;
        }
        at += 2 + std::size_t(byte(at + 2) << 8 | byte(at + 3));
    }
    return found;
}

} // namespace

bool is_jpeg(std::string_view bytes) { return bytes.starts_with("\xFF\xD8\xFF"); }

JpegHeader read_jpeg_header(std::string_view bytes) {
    const Segments segments = read_segments(bytes);
    if (segments.is_lossless || segments.bits != 8)
        throw DecodeError(fmt::format("it is a {}JPEG of {} bits a channel, and raylab reads lossy "
                                      "ones of 8: save it as such "
                                      "a JPEG, or as a PNG, which may have 16",
                                      segments.is_lossless ? "lossless " : "", segments.bits));
    const Decoder decoder = make_decoder();
    JpegHeader header;
    int subsampling = 0, colorspace = 0;
    if (tjDecompressHeader3(decoder.get(), data(bytes), bytes.size(), &header.width, &header.height,
                            &subsampling, &colorspace) != 0)
        fail(decoder);
    header.is_cmyk = colorspace == TJCS_CMYK || colorspace == TJCS_YCCK;
    header.is_inverted = segments.is_adobe;
    return header;
}

std::vector<unsigned char> jpeg_texels(std::string_view bytes, const JpegHeader& header) {
    const Decoder decoder = make_decoder();
    const std::size_t texels = std::size_t(header.width) * std::size_t(header.height);
    std::vector<unsigned char> samples(texels * (header.is_cmyk ? 4 : 3));
    // A warning is an error here, for libjpeg-turbo fills in grey what a file lacks; and a hostile
    // file may have a hundred thousand scans of one image.
    constexpr int flags = TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT;
    if (tjDecompress2(decoder.get(), data(bytes), bytes.size(), samples.data(), header.width, 0,
                      header.height, header.is_cmyk ? TJPF_CMYK : TJPF_RGB, flags) != 0)
        fail(decoder);
    if (!header.is_cmyk) return samples;
    // Each ink lets through what it does not absorb: R = (1 - C) (1 - K). Without the printer's
    // profile that is all there is to say.
    std::vector<unsigned char> rgb(3 * texels);
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        const int ink = samples[i / 3 * 4 + i % 3], black = samples[i / 3 * 4 + 3];
        const int light = header.is_inverted ? ink * black : (255 - ink) * (255 - black);
        rgb[i] = static_cast<unsigned char>((light + 127) / 255);
    }
    return rgb;
}

} // namespace raylab
