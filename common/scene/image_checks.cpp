// PNG (ISO/IEC 15948, 5.3): chunks of a length, a name of four letters, data, and a check sum.
#include "common/scene/image_checks.h"

#include <algorithm>

namespace raylab {
namespace {

// The byte at `at`, or 255 behind the end: a chunk that is cut off must not fit.
int byte(std::string_view bytes, std::size_t at) {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 255;
}

int length_at(std::string_view bytes, std::size_t at) {
    return byte(bytes, at) << 8 | byte(bytes, at + 1);
}

} // namespace

bool png_chunks_fit(std::string_view bytes) {
    constexpr std::string_view signature("\x89PNG\r\n\x1a\n");
    if (!bytes.starts_with(signature)) return true;
    constexpr std::size_t name_and_length = 8, check_sum = 4;
    for (std::size_t at = signature.size(); bytes.size() - at >= name_and_length;) {
        const std::size_t length =
            std::size_t(length_at(bytes, at)) << 16 | std::size_t(length_at(bytes, at + 2));
        const std::string_view name = bytes.substr(at + 4, 4);
        if (name == "IEND") return true;
        if (length > bytes.size() - at - name_and_length || (name == "IDAT" && length == 0))
            return false;
        at = std::min(at + name_and_length + length + check_sum, bytes.size());
    }
    return false;
}

} // namespace raylab
