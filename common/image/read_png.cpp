// PNG (ISO/IEC 15948) by libspng, which verifies the check sum of every chunk and of the
// compressed data: a picture with a wrong bit is an error, not another picture.
#include "common/image/decode.h"
#include "common/image/display.h"

#include <fmt/format.h>
#include <spng.h>

#include <limits>
#include <memory>
#include <vector>

namespace raylab {
namespace {

using Decoder = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;

constexpr std::string_view signature("\x89PNG\r\n\x1a\n");

void check(int error) {
    if (error == SPNG_OK) return;
    if (error == SPNG_IO_EOF || error == SPNG_EIDAT_TOO_SHORT)
        throw DecodeError("it ends too early");
    if (error == SPNG_ECHUNK_CRC) throw DecodeError("it is damaged: a check sum in it is wrong");
    throw DecodeError(fmt::format("it is damaged ({})", spng_strerror(error)));
}

// Linear values of all that `bits` can say.
std::vector<float> linear_values(int bits) {
    std::vector<float> values(std::size_t(1) << bits);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = linear_from_srgb(double(i) / double(values.size() - 1));
    return values;
}

// Decodes into R, G, B, A samples.
template <class Sample>
void decode(spng_ctx* decoder, int format, Image& image, std::vector<float>* alpha) {
    constexpr std::size_t channels = 4;
    constexpr Sample opaque = std::numeric_limits<Sample>::max();
    std::vector<Sample> samples(image.pixels() * channels);
    check(spng_decode_image(decoder, samples.data(), samples.size() * sizeof(Sample), format,
                            SPNG_DECODE_TRNS));
    const std::vector<float> linear = linear_values(8 * sizeof(Sample));
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const Sample* rgb = &samples[i * channels];
        image.mean[i] = Vec3(linear[rgb[0]], linear[rgb[1]], linear[rgb[2]]);
        if (!alpha) continue;
        if (rgb[3] < opaque && alpha->empty()) alpha->assign(image.pixels(), 1);
        if (!alpha->empty()) (*alpha)[i] = float(rgb[3]) / float(opaque);
    }
}

} // namespace

bool is_png(std::string_view bytes) { return bytes.starts_with(signature); }

Image decode_png(std::string_view bytes, PictureLimits limits, std::vector<float>* alpha) {
    const Decoder decoder(spng_ctx_new(0), spng_ctx_free);
    if (!decoder) throw std::bad_alloc();
    check(spng_set_crc_action(decoder.get(), SPNG_CRC_ERROR, SPNG_CRC_ERROR));
    // A chunk is never larger than its file, but what libspng keeps of it may be: libspng inflates
    // text and colour profiles, and adds its own structures, more than 91 bytes for a word of text.
    constexpr std::size_t most_kept = std::size_t{8} << 20;
    check(spng_set_chunk_limits(decoder.get(), bytes.size(), bytes.size() + most_kept));
    check(spng_set_png_buffer(decoder.get(), bytes.data(), bytes.size()));
    spng_ihdr header{};
    check(spng_get_ihdr(decoder.get(), &header));
    check_picture_size(header.width, header.height, bytes.size(), limits);

    Image image;
    image.width = int(header.width);
    image.height = int(header.height);
    image.mean.resize(image.pixels());
    if (header.bit_depth == 16)
        decode<std::uint16_t>(decoder.get(), SPNG_FMT_RGBA16, image, alpha);
    else
        decode<std::uint8_t>(decoder.get(), SPNG_FMT_RGBA8, image, alpha);
    check(spng_decode_chunks(decoder.get())); // up to the last one
    return image;
}

} // namespace raylab
