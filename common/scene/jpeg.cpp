#include "common/scene/jpeg.h"

#include <turbojpeg.h>

#include <memory>

namespace raylab {
namespace {

using Decoder = std::unique_ptr<void, decltype(&tjDestroy)>;

Decoder make_decoder() { return {tjInitDecompress(), tjDestroy}; }

[[noreturn]] void fail(const Decoder& decoder) { throw JpegError(tjGetErrorStr2(decoder.get())); }

const unsigned char* data(std::string_view bytes) {
    return reinterpret_cast<const unsigned char*>(bytes.data());
}

} // namespace

bool is_jpeg(std::string_view bytes) { return bytes.starts_with("\xFF\xD8\xFF"); }

PictureSize jpeg_size(std::string_view bytes) {
    const Decoder decoder = make_decoder();
    PictureSize size;
    int subsampling = 0, colorspace = 0;
    if (tjDecompressHeader3(decoder.get(), data(bytes), bytes.size(), &size.width, &size.height,
                            &subsampling, &colorspace) != 0)
        fail(decoder);
    return size;
}

std::vector<unsigned char> jpeg_texels(std::string_view bytes, PictureSize size) {
    const Decoder decoder = make_decoder();
    std::vector<unsigned char> rgb(std::size_t(size.width) * std::size_t(size.height) * 3);
    // A warning is an error here, for libjpeg-turbo fills in grey what a file lacks; and a hostile
    // file may have a hundred thousand scans of one image.
    constexpr int flags = TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT;
    if (tjDecompress2(decoder.get(), data(bytes), bytes.size(), rgb.data(), size.width, 0,
                      size.height, TJPF_RGB, flags) != 0)
        fail(decoder);
    return rgb;
}

} // namespace raylab
