// Which format a name means, and errors that name the file.
#include "common/image/image_file.h"

#include "common/cli/files.h"
#include "common/image/decode.h"
#include "common/image/formats.h"

#include <fmt/format.h>

namespace raylab {
namespace {

constexpr const char* endings = ".exr, .pfm, .hdr or .png";
constexpr PictureLimits limits{max_image_side, std::int64_t(max_image_pixels)};

[[noreturn]] void unknown_ending(const std::string& path) {
    throw ImageError(
        fmt::format("'{}' is not a name of an image file: it should end in {}", path, endings));
}

} // namespace

Image formats::allocate(long long width, long long height, std::size_t bytes_in_file) {
    check_picture_size(width, height, bytes_in_file, limits);
    Image image;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.mean.resize(image.pixels());
    return image;
}

Image read_image(const std::string& path) {
    const std::string ending = ending_of(path);
    if (ending != ".exr" && ending != ".pfm" && ending != ".hdr" && ending != ".png")
        unknown_ending(path);
    try {
        const std::string bytes = read_file(path);
        if (bytes.empty()) throw std::runtime_error("it is empty (0 bytes)");
        return ending == ".exr"   ? formats::decode_exr(bytes)
               : ending == ".pfm" ? formats::decode_pfm(bytes)
               : ending == ".hdr" ? decode_hdr(bytes, limits)
                                  : decode_png(bytes, limits);
    } catch (const FileError& e) {
        throw ImageError(e.what());
    } catch (const std::bad_alloc&) {
        throw ImageError(fmt::format("cannot read '{}': not enough memory", path));
    } catch (const std::exception& e) {
        throw ImageError(fmt::format("cannot read '{}' as an {} image: {}; render or copy it again",
                                     path, ending.substr(1), e.what()));
    }
}

void write_image(const Image& image, const std::string& path, float exposure) {
    if (image.width < 1 || image.height < 1 || image.mean.size() != image.pixels() ||
        (!image.error.empty() && image.error.size() != image.pixels()))
        throw ImageError(fmt::format("cannot write '{}': the image is {} x {} but holds {} pixels "
                                     "and {} errors",
                                     path, image.width, image.height, image.mean.size(),
                                     image.error.size()));
    const std::string ending = ending_of(path);
    if (ending == ".exr")
        write_file(path, formats::encode_exr(image));
    else if (ending == ".pfm")
        write_file(path, formats::encode_pfm(image));
    else if (ending == ".hdr")
        write_file(path, formats::encode_hdr(image));
    else if (ending == ".png")
        write_file(path, encode_png(image, exposure));
    else
        unknown_ending(path);
}

} // namespace raylab
